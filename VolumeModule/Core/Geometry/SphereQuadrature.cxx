#include "Core/Geometry/SphereQuadrature.h"

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

#include <cmath>

namespace varimarch
{

namespace
{

using Directions = std::array<WeightedDirection, SphereDirections>;

constexpr double IcosahedronWeight = 5.0 / 168.0;
constexpr double DodecahedronWeight = 9.0 / 280.0;

Directions MadeDirections()
{
  const double golden = 0.5 * (1.0 + std::sqrt(5.0));
  const glm::dmat3 turned(glm::rotate(glm::dmat4(1.0), 1.0, glm::dvec3(1.0, 2.0, 3.0)));
  Directions directions;
  int count = 0;
  const auto add = [&](glm::dvec3 corner, double weight) {
    directions[count++] = { turned * glm::normalize(corner), weight };
  };
  for (const double a : { -1.0, 1.0 })
  {
    for (const double b : { -1.0, 1.0 })
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        glm::dvec3 ofIcosahedron(0.0);
        ofIcosahedron[axis] = a;
        ofIcosahedron[(axis + 1) % 3] = b * golden;
        add(ofIcosahedron, IcosahedronWeight);
        glm::dvec3 ofDodecahedron(0.0);
        ofDodecahedron[axis] = a * golden;
        ofDodecahedron[(axis + 1) % 3] = b / golden;
        add(ofDodecahedron, DodecahedronWeight);
      }
      add({ a, b, -1.0 }, DodecahedronWeight);
      add({ a, b, 1.0 }, DodecahedronWeight);
    }
  }
  return directions;
}

}

const std::array<WeightedDirection, SphereDirections>& SphereQuadrature()
{
  static const Directions directions = MadeDirections();
  return directions;
}

}
