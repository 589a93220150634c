#include "Core/Geometry/PixelRays.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace varimarch
{

namespace
{

// Clip depth of the box's nearest corner, no nearer than the near plane.
double NearestClipDepth(const glm::dmat4& clipFromGrid, const Box& box)
{
  constexpr double nearPlane = -1.0;
  double nearest = 1.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::dvec4 positionGrid(corner & 1 ? box.upper.x : box.lower.x,
      corner & 2 ? box.upper.y : box.lower.y, corner & 4 ? box.upper.z : box.lower.z, 1.0);
    const glm::dvec4 clip = clipFromGrid * positionGrid;
    // A corner beside or behind the eye: the camera is inside, or close.
    nearest = clip.w > 0.0 ? std::min(nearest, clip.z / clip.w) : nearPlane;
    if (!(nearest > nearPlane))
    {
      return nearPlane;
    }
  }
  return nearest;
}

}

PixelRays ComputePixelRays(const glm::dmat4& clipFromGrid, const Box& boxGrid)
{
  const glm::dmat4 gridFromClip = glm::inverse(clipFromGrid);
  const glm::dvec4 alongX = gridFromClip[0];
  const glm::dvec4 alongY = gridFromClip[1];
  const glm::dvec4 alongDepth = gridFromClip[2];
  const glm::dvec4 centre = gridFromClip[3];

  // The points of a pixel are h(z) = centre + x alongX + y alongY + z alongDepth, homogeneous.
  // Differentiating h.xyz / h.w by z leaves a direction that no longer depends on z.
  const auto direction = [&](const glm::dvec4& part)
  { return glm::dvec3(alongDepth) * part.w - glm::dvec3(part) * alongDepth.w; };

  PixelRays rays;
  rays.startGrid = { centre + NearestClipDepth(clipFromGrid, boxGrid) * alongDepth, alongX,
    alongY };
  rays.directionGrid = { direction(centre), direction(alongX), direction(alongY) };
  // All rays meet where x, y and w of clip space vanish: alongDepth. By the derivative above
  // alongDepth.xyz - start * alongDepth.w points away from the eye where the start's w is positive.
  rays.eyeGrid = rays.startGrid[0].w > 0.0 ? -alongDepth : alongDepth;
  rays.nearPlaneGrid = glm::row(clipFromGrid, 3) + glm::row(clipFromGrid, 2);
  rays.farPlaneGrid = glm::row(clipFromGrid, 3) - glm::row(clipFromGrid, 2);

  // Scales cancel out of every use; without them float uniforms cannot overflow.
  const double startScale = 1.0 / rays.startGrid[0].w;
  const double directionScale = 1.0 / glm::length(rays.directionGrid[0]);
  const double planeScale = 1.0 / glm::length(glm::dvec3(rays.nearPlaneGrid));
  if (!std::isfinite(startScale * directionScale * planeScale))
  {
    throw std::invalid_argument(
      "the camera's and the volume's matrices have no inverse: there are no rays to draw along");
  }
  for (int i = 0; i < 3; ++i)
  {
    rays.startGrid[i] *= startScale;
    rays.directionGrid[i] *= directionScale;
  }
  rays.nearPlaneGrid *= planeScale;
  // The far plane may be at infinity, where it cuts nothing.
  rays.farPlaneGrid *= planeScale;
  return rays;
}

Ray PixelRays::At(double x, double y) const
{
  const glm::dvec4 start = this->startGrid[0] + x * this->startGrid[1] + y * this->startGrid[2];
  return { glm::dvec3(start) / start.w,
    this->directionGrid[0] + x * this->directionGrid[1] + y * this->directionGrid[2] };
}

Interval PixelRays::BetweenPlanes(const Ray& rayGrid) const
{
  const glm::dvec4 origin(rayGrid.origin, 1.0);
  const double approach = glm::dot(glm::dvec3(this->nearPlaneGrid), rayGrid.direction);
  const double departure = -glm::dot(glm::dvec3(this->farPlaneGrid), rayGrid.direction);
  return { approach > 0.0 ? std::max(0.0, -glm::dot(this->nearPlaneGrid, origin) / approach) : 0.0,
    departure > 0.0 ? glm::dot(this->farPlaneGrid, origin) / departure
                    : std::numeric_limits<double>::infinity() };
}

}
