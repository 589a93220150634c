#ifndef Varimarch_Core_Geometry_SphereQuadrature_h
#define Varimarch_Core_Geometry_SphereQuadrature_h

#include <glm/vec3.hpp>

#include <array>

namespace varimarch
{

/// A direction of a quadrature.
struct WeightedDirection
{
  glm::dvec3 direction; ///< unit vector
  double weight;        ///< > 0
};

constexpr int SphereDirections = 32;

/// The rule U3 9-1 of A. Stroud, "Approximate calculation of multiple integrals" (1971): the
/// corners of an icosahedron and those of the dodecahedron that is dual to it, with two weights,
/// whose sum is 1. Means over the sphere of polynomials of degree up to 9 are exact. The directions
/// are turned by a radian about (1, 2, 3), so that none lies in a plane of the axes.
const std::array<WeightedDirection, SphereDirections>& SphereQuadrature();

}

#endif
