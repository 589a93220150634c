#include "Core/Reference/LightTransmittance.h"

#include <glm/geometric.hpp>

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

double SkyVisibility::At(glm::dvec3 positionGrid) const
{
  double sum = 0.0;
  for (const auto& [direction, weight] : SphereQuadrature())
  {
    sum += weight * this->transmittance.Towards(positionGrid, direction, this->reachMm);
  }
  return sum;
}

glm::dvec3 OutsideOf(glm::dvec3 positionGrid, glm::dvec3 gradient, bool isThinnerUp)
{
  constexpr double DistanceVoxels = 2.0;
  const double length = glm::length(gradient);
  const double signedDistance = isThinnerUp ? DistanceVoxels : -DistanceVoxels;
  return length > 0.0 ? positionGrid + (signedDistance / length) * gradient : positionGrid;
}

bool IsThinnerUp(
  double value, glm::dvec3 gradient, const std::function<double(double value)>& extinctionOf)
{
  constexpr double Less = 0.99;
  const double perVoxel = glm::length(gradient);
  return extinctionOf(value + perVoxel) < Less * extinctionOf(value - perVoxel);
}

double KeptLight(double visibility, double strength)
{
  return visibility / (visibility + strength * (1.0 - visibility));
}

}
