#include "Core/Reference/LightTransmittance.h"

#include <utility>

namespace varimarch
{

namespace
{

ReferenceScene Unlit(ReferenceScene scene)
{
  scene.blend = Blend::Composite;
  scene.shade = {};
  return scene;
}

}

LightTransmittance::LightTransmittance(
  ReferenceScene scene, const glm::dmat3& gridFromWorldDirection, double tolerance)
  : gridFromWorldDirection(gridFromWorldDirection)
  , integrator(Unlit(std::move(scene)), tolerance)
{
}

double LightTransmittance::Towards(
  glm::dvec3 positionGrid, glm::dvec3 towardsWorld, double farMm) const
{
  const Ray ray{ positionGrid, this->gridFromWorldDirection * towardsWorld };
  return 1.0 - this->integrator.Color(ray, 1.0, { 0.0, farMm }).rgba.a;
}

}
