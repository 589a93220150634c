#ifndef Varimarch_Core_Geometry_LightCone_h
#define Varimarch_Core_Geometry_LightCone_h

#include "Core/Geometry/SphereQuadrature.h"

#include <glm/vec3.hpp>

#include <array>

namespace varimarch
{

/// A place of a quadrature on the unit disc.
struct DiscPoint
{
  double x;
  double y;
  double weight; ///< > 0
};

constexpr int ConeDirections = 12;

/// The rule S2 7-1 of A. Stroud, "Approximate calculation of multiple integrals" (1971), whose
/// weights have the sum 1. Means over the unit disc of polynomials of degree up to 7 are exact.
const std::array<DiscPoint, ConeDirections>& DiscQuadrature();

/// Directions in a cone, whose weighted mean is that over all of its directions. The disc is the
/// cap of the sphere around the axis, without a change of areas.
/// @param axis              unit vector
/// @param halfAngleRadians  angle between the axis and the edge of the cone, (0, pi/2]
std::array<WeightedDirection, ConeDirections> DirectionsInCone(
  glm::dvec3 axis, double halfAngleRadians);

}

#endif
