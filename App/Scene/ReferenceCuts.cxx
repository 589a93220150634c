#include "Scene/ReferenceCuts.h"

#include "Core/Geometry/CellWalk.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

namespace varimarch
{

namespace
{

// Clips an interval of a ray to the positive side of a plane.
Interval PositivePart(const glm::dvec4& plane, const Ray& ray, Interval part)
{
  const double atOrigin = glm::dot(plane, glm::dvec4(ray.origin, 1.0));
  const double perLength = glm::dot(glm::dvec3(plane), ray.direction);
  if (perLength == 0.0)
  {
    return atOrigin >= 0.0 ? part : Interval{ 0.0, 0.0 };
  }
  double& end = perLength > 0.0 ? part.enter : part.exit;
  const double crossing = -atOrigin / perLength;
  end = perLength > 0.0 ? std::max(end, crossing) : std::min(end, crossing);
  return part;
}

// Each voxel of a mask fills the box around it.
std::vector<Interval> KeptParts(
  vtkImageData* mask, const Ray& rayGrid, Interval inside, glm::ivec3 dimensions)
{
  const glm::ivec3 last = glm::make_vec3(mask->GetDimensions()) - 1;
  const glm::dvec3 maskPerGrid = glm::dvec3(last + 1) / glm::dvec3(dimensions);
  const Ray rayMask{ (rayGrid.origin + 0.5) * maskPerGrid, rayGrid.direction * maskPerGrid };
  std::vector<Interval> parts;
  WalkCells(rayMask, inside,
    [&](const CellPart& part)
    {
      const glm::ivec3 voxel = glm::clamp(part.cell, glm::ivec3(0), last);
      const bool isKept =
        *static_cast<const unsigned char*>(mask->GetScalarPointer(voxel.x, voxel.y, voxel.z)) != 0;
      if (isKept && !parts.empty() && parts.back().exit == part.t.enter)
      {
        parts.back().exit = part.t.exit;
      }
      else if (isKept)
      {
        parts.push_back(part.t);
      }
      return true;
    });
  return parts;
}

}

std::vector<Interval> ReferenceCuts::PartsOf(
  const Ray& rayGrid, Interval inside, glm::ivec3 dimensions) const
{
  for (const glm::dvec4& plane : this->planesGrid)
  {
    inside = PositivePart(plane, rayGrid, inside);
  }
  if (inside.IsEmpty())
  {
    return {};
  }
  return this->mask ? KeptParts(this->mask, rayGrid, inside, dimensions)
                    : std::vector<Interval>{ inside };
}

}
