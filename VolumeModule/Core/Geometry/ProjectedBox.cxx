#include "Core/Geometry/ProjectedBox.h"

#include <glm/common.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <limits>

namespace varimarch
{

CornersClip CornersOf(const Box& box, const glm::dmat4& clipFromGrid)
{
  CornersClip corners;
  for (int corner = 0; corner < 8; ++corner)
  {
    corners[corner] = clipFromGrid *
      glm::dvec4(corner & 1 ? box.upper.x : box.lower.x, corner & 2 ? box.upper.y : box.lower.y,
        corner & 4 ? box.upper.z : box.lower.z, 1.0);
  }
  return corners;
}

Box BoxAround(const Box& box, const glm::dmat4& otherFromBox)
{
  constexpr double Infinity = std::numeric_limits<double>::infinity();
  Box around{ glm::dvec3(Infinity), glm::dvec3(-Infinity) };
  for (const glm::dvec4& corner : CornersOf(box, otherFromBox))
  {
    around.lower = glm::min(around.lower, glm::dvec3(corner));
    around.upper = glm::max(around.upper, glm::dvec3(corner));
  }
  return around;
}

bool IsInView(const Box& box, const glm::dmat4& clipFromGrid)
{
  const CornersClip corners = CornersOf(box, clipFromGrid);
  for (int axis = 0; axis < 3; ++axis)
  {
    for (double side : { -1.0, 1.0 })
    {
      const auto isBeyond = [&](const glm::dvec4& corner)
      { return side * corner[axis] > corner.w; };
      if (std::all_of(corners.begin(), corners.end(), isBeyond))
      {
        return false;
      }
    }
  }
  return true;
}

Viewport PixelsOf(const Box& box, const glm::dmat4& clipFromGrid, const Viewport& picture)
{
  const glm::dvec2 size(picture.width, picture.height);
  glm::dvec2 lower = size;
  glm::dvec2 upper(0.0);
  for (const glm::dvec4& corner : CornersOf(box, clipFromGrid))
  {
    if (!(corner.w > 0.0))
    {
      return picture; // the eye is beside the box, or in it
    }
    const glm::dvec2 pixel = (glm::dvec2(corner) / corner.w * 0.5 + 0.5) * size;
    lower = glm::min(lower, pixel);
    upper = glm::max(upper, pixel);
  }
  const glm::ivec2 first(glm::clamp(glm::floor(lower), glm::dvec2(0.0), size));
  const glm::ivec2 behind(glm::clamp(glm::ceil(upper), glm::dvec2(first), size));
  return { first.x, first.y, behind.x - first.x, behind.y - first.y };
}

double LargestMove(const CornersClip& from, const CornersClip& to)
{
  double largest = 0.0;
  for (std::size_t corner = 0; corner < from.size(); ++corner)
  {
    if (!(from[corner].w > 0.0 && to[corner].w > 0.0))
    {
      return std::numeric_limits<double>::infinity();
    }
    const glm::dvec2 moved =
      glm::dvec2(to[corner]) / to[corner].w - glm::dvec2(from[corner]) / from[corner].w;
    // The picture is two wide and high.
    largest = std::max({ largest, 0.5 * std::abs(moved.x), 0.5 * std::abs(moved.y) });
  }
  return largest;
}

}
