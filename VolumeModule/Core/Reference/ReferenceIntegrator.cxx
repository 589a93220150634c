#include "Core/Reference/ReferenceIntegrator.h"

#include <stdexcept>
#include <string>

namespace varimarch
{

ReferenceIntegrator::ReferenceIntegrator(const ReferenceScene& scene, double tolerance)
  : boxGrid(scene.boxGrid)
  , uncutParts(scene.uncutParts)
  , integral(NewRayIntegral(scene, tolerance))
{
  if (!(tolerance >= SmallestTolerance))
  {
    throw std::invalid_argument(
      "Reference: the tolerance must be 1e-12 or more, found " + std::to_string(tolerance));
  }
  if (!scene.cornersOfCell && !scene.material)
  {
    throw std::invalid_argument("Reference: the scene must have voxels or a material, found none");
  }
}

ReferenceColor ReferenceIntegrator::Color(
  const Ray& rayGrid, double mmPerParameter, Interval limits) const
{
  const Interval inside = Intersection(rayGrid, this->boxGrid, limits);
  const glm::dvec4 transparent(0.0);
  if (inside.IsEmpty())
  {
    return { transparent, 0.0 };
  }
  if (!this->uncutParts)
  {
    return this->integral->Along({ rayGrid, mmPerParameter, { inside } });
  }
  const std::vector<Interval> left = this->uncutParts(rayGrid, inside);
  return left.empty() ? ReferenceColor{ transparent, 0.0 }
                      : this->integral->Along({ rayGrid, mmPerParameter, left });
}

}
