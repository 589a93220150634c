#include "Core/ReferenceIntegrator.h"

#include <stdexcept>
#include <string>

namespace varimarch
{

ReferenceIntegrator::ReferenceIntegrator(const ReferenceScene& scene, double tolerance)
  : boxGrid(scene.boxGrid)
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
  if (inside.IsEmpty())
  {
    return { glm::dvec4(0.0), 0.0 };
  }
  return this->integral->Along({ rayGrid, mmPerParameter, inside });
}

}
