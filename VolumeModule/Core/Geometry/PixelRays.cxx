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

// Clip depth of the box's nearest corner, but not in front of the near plane.
double NearestClipDepth(const glm::dmat4& clipFromGrid, const Box& box)
{
  constexpr double nearPlane = -1.0;
  double nearest = 1.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::dvec4 positionGrid(corner & 1 ? box.upper.x : box.lower.x,
      corner & 2 ? box.upper.y : box.lower.y, corner & 4 ? box.upper.z : box.lower.z, 1.0);
    const glm::dvec4 clip = clipFromGrid * positionGrid;
    // A corner beside or behind the eye means that the camera is inside the volume or close to it.
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

  // A pixel sees the homogeneous points h(z) = centre + x alongX + y alongY + z alongDepth. The
  // derivative of h.xyz / h.w with respect to z has a direction independent of z.
  const auto direction = [&](const glm::dvec4& part)
  { return glm::dvec3(alongDepth) * part.w - glm::dvec3(part) * alongDepth.w; };

  PixelRays rays;
  rays.startGrid = { centre + NearestClipDepth(clipFromGrid, boxGrid) * alongDepth, alongX,
    alongY };
  rays.directionGrid = { direction(centre), direction(alongX), direction(alongY) };
  // All rays meet in the point whose clip coordinates x, y and w are 0: alongDepth. By the
  // derivative above, alongDepth.xyz - start * alongDepth.w points away from the eye if the start's
  // w is positive.
  rays.eyeGrid = rays.startGrid[0].w > 0.0 ? -alongDepth : alongDepth;
  rays.nearPlaneGrid = glm::row(clipFromGrid, 3) + glm::row(clipFromGrid, 2);
  rays.farPlaneGrid = glm::row(clipFromGrid, 3) - glm::row(clipFromGrid, 2);

  // These scales cancel in every use, but prevent overflow in uniforms of type float.
  const double startScale = 1.0 / rays.startGrid[0].w;
  const double directionScale = 1.0 / glm::length(rays.directionGrid[0]);
  const double planeScale = 1.0 / glm::length(glm::dvec3(rays.nearPlaneGrid));
  if (!std::isfinite(startScale * directionScale * planeScale))
  {
    throw std::invalid_argument(
      "The matrix of the camera or of the volume has no inverse, so no rays can be cast");
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
