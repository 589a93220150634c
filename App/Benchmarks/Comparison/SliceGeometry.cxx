#include "SliceGeometry.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace varimarch
{

namespace
{

glm::dvec3 CornerOf(const Box& box, int corner)
{
  return { corner & 1 ? box.upper.x : box.lower.x, corner & 2 ? box.upper.y : box.lower.y,
    corner & 4 ? box.upper.z : box.lower.z };
}

std::array<glm::dvec3, 8> CornersWorld(const Box& boxGrid, const glm::dmat4& worldFromGrid)
{
  std::array<glm::dvec3, 8> corners;
  for (int corner = 0; corner < 8; ++corner)
  {
    corners[corner] = glm::dvec3(worldFromGrid * glm::dvec4(CornerOf(boxGrid, corner), 1.0));
  }
  return corners;
}

glm::dvec3 MiddleOf(const Polygon& polygon)
{
  glm::dvec3 sum(0.0);
  for (const glm::dvec3& corner : polygon)
  {
    sum += corner;
  }
  return sum / double(polygon.size());
}

// The points in which a plane meets the edges of a box.
Polygon PointsOnEdges(const Box& box, const glm::dvec4& plane)
{
  Polygon points;
  for (int corner = 0; corner < 8; ++corner)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      if (corner >> axis & 1)
      {
        continue; // each edge begins at its lower corner
      }
      const glm::dvec3 from = CornerOf(box, corner);
      const glm::dvec3 to = CornerOf(box, corner | 1 << axis);
      const double atFrom = glm::dot(plane, glm::dvec4(from, 1.0));
      const double atTo = glm::dot(plane, glm::dvec4(to, 1.0));
      // A corner in the plane belongs to one side, so that it is found on some edges only.
      if ((atFrom >= 0.0) != (atTo >= 0.0))
      {
        points.push_back(glm::mix(from, to, atFrom / (atFrom - atTo)));
      }
    }
  }
  return points;
}

// Two vectors that span a plane and, with its normal, are right-handed.
std::array<glm::dvec3, 2> SpanOf(const glm::dvec3& normal)
{
  const glm::dvec3 size = glm::abs(normal);
  const glm::dvec3 other = size.x <= size.y && size.x <= size.z ? glm::dvec3(1.0, 0.0, 0.0)
    : size.y <= size.z                                          ? glm::dvec3(0.0, 1.0, 0.0)
                                                                : glm::dvec3(0.0, 0.0, 1.0);
  const glm::dvec3 first = glm::normalize(glm::cross(other, normal));
  return { first, glm::cross(glm::normalize(normal), first) };
}

// The middles of layers that cover a range: multiples of their thickness, plus a half.
std::vector<double> Middles(double first, double last, double layerMm)
{
  std::vector<double> middles;
  for (double index = std::floor(first / layerMm); index * layerMm < last; ++index)
  {
    middles.push_back((index + 0.5) * layerMm);
  }
  return middles;
}

}

Polygon SlicePolygon(const Box& box, const glm::dvec4& plane)
{
  Polygon points = PointsOnEdges(box, plane);
  if (points.size() < 3)
  {
    return {};
  }
  const glm::dvec3 middle = MiddleOf(points);
  const auto [right, up] = SpanOf(glm::dvec3(plane));
  const auto angle = [&, right = right, up = up](const glm::dvec3& point)
  { return std::atan2(glm::dot(point - middle, up), glm::dot(point - middle, right)); };
  std::sort(points.begin(), points.end(),
    [&](const glm::dvec3& a, const glm::dvec3& b) { return angle(a) < angle(b); });
  return points;
}

double AreaOf(const Polygon& polygon)
{
  glm::dvec3 sum(0.0);
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    sum +=
      glm::cross(polygon[i] - polygon.front(), polygon[(i + 1) % polygon.size()] - polygon.front());
  }
  return 0.5 * glm::length(sum);
}

void AddFan(const Polygon& polygon, std::vector<glm::vec3>& triangles)
{
  if (polygon.empty())
  {
    return;
  }
  const glm::dvec3 middle = MiddleOf(polygon);
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    triangles.insert(triangles.end(),
      { glm::vec3(middle), glm::vec3(polygon[i]), glm::vec3(polygon[(i + 1) % polygon.size()]) });
  }
}

std::vector<glm::dvec4> PlanesAlong(const glm::dvec3& normalWorld, double layerMm,
  const Box& boxGrid, const glm::dmat4& worldFromGrid)
{
  double first = std::numeric_limits<double>::infinity();
  double last = -first;
  for (const glm::dvec3& corner : CornersWorld(boxGrid, worldFromGrid))
  {
    first = std::min(first, glm::dot(corner, normalWorld));
    last = std::max(last, glm::dot(corner, normalWorld));
  }
  std::vector<glm::dvec4> planes;
  for (const double place : Middles(first, last, layerMm))
  {
    planes.push_back(glm::dvec4(normalWorld, -place) * worldFromGrid);
  }
  return planes;
}

int StackAxis(const glm::dvec3& directionWorld, const glm::dmat4& worldFromGrid)
{
  std::array<double, 3> along;
  for (int axis = 0; axis < 3; ++axis)
  {
    const glm::dvec3 axisWorld = glm::normalize(glm::dvec3(worldFromGrid[axis]));
    along[axis] = std::abs(glm::dot(axisWorld, directionWorld));
  }
  return int(std::max_element(along.begin(), along.end()) - along.begin());
}

std::vector<double> ShellRadii(
  const glm::dvec3& eyeWorld, double layerMm, const Box& boxGrid, const glm::dmat4& worldFromGrid)
{
  const glm::dvec3 eyeGrid = glm::dvec3(glm::inverse(worldFromGrid) * glm::dvec4(eyeWorld, 1.0));
  const glm::dvec3 nearest = glm::clamp(eyeGrid, boxGrid.lower, boxGrid.upper);
  // The nearest point in the grid is not the nearest in the world if voxels are not cubes, but
  // never farther than it.
  const double scale = std::min({ glm::length(glm::dvec3(worldFromGrid[0])),
    glm::length(glm::dvec3(worldFromGrid[1])), glm::length(glm::dvec3(worldFromGrid[2])) });
  double last = 0.0;
  for (const glm::dvec3& corner : CornersWorld(boxGrid, worldFromGrid))
  {
    last = std::max(last, glm::distance(corner, eyeWorld));
  }
  return Middles(scale * glm::distance(nearest, eyeGrid), last, layerMm);
}

std::vector<glm::vec3> CoverOf(const Box& boxGrid, const glm::dmat4& clipFromGrid)
{
  glm::dvec2 lower(1.0);
  glm::dvec2 upper(-1.0);
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::dvec4 clip = clipFromGrid * glm::dvec4(CornerOf(boxGrid, corner), 1.0);
    const bool behind = clip.w <= 0.0;
    lower = glm::min(lower, behind ? glm::dvec2(-1.0) : glm::dvec2(clip) / clip.w);
    upper = glm::max(upper, behind ? glm::dvec2(1.0) : glm::dvec2(clip) / clip.w);
  }
  const glm::dmat4 gridFromClip = glm::inverse(clipFromGrid);
  const auto at = [&](double x, double y)
  {
    const glm::dvec4 point = gridFromClip * glm::dvec4(x, y, 0.0, 1.0);
    return glm::vec3(glm::dvec3(point) / point.w);
  };
  lower = glm::max(lower, glm::dvec2(-1.0));
  upper = glm::min(upper, glm::dvec2(1.0));
  return { at(lower.x, lower.y), at(upper.x, lower.y), at(upper.x, upper.y), at(lower.x, lower.y),
    at(upper.x, upper.y), at(lower.x, upper.y) };
}

}
