#include "Core/Geometry/LightCone.h"

#include <cmath>

namespace varimarch
{

namespace
{

/// Two unit vectors that are perpendicular to a third and to each other.
struct Tangents
{
  glm::dvec3 first;
  glm::dvec3 second;
};

// The method of Duff and others, "Building an orthonormal basis, revisited" (Journal of Computer
// Graphics Techniques 6(1), 2017).
Tangents TangentsOf(glm::dvec3 n)
{
  const double side = n.z < 0.0 ? -1.0 : 1.0;
  const double a = -1.0 / (side + n.z);
  const double b = n.x * n.y * a;
  return { { 1.0 + side * n.x * n.x * a, side * b, -side * n.x },
    { b, side + n.y * n.y * a, -n.y } };
}

std::array<DiscPoint, ConeDirections> MakeDiscQuadrature()
{
  const double root = std::sqrt(29.0);
  const double onAxes = std::sqrt(0.75);
  const double inner = std::sqrt((27.0 - 3.0 * root) / 104.0);
  const double outer = std::sqrt((27.0 + 3.0 * root) / 104.0);
  const double ofAxes = 2.0 / 27.0;
  const double ofInner = (551.0 + 41.0 * root) / 6264.0;
  const double ofOuter = (551.0 - 41.0 * root) / 6264.0;
  return { { { onAxes, 0.0, ofAxes }, { -onAxes, 0.0, ofAxes }, { 0.0, onAxes, ofAxes },
    { 0.0, -onAxes, ofAxes }, { inner, inner, ofInner }, { inner, -inner, ofInner },
    { -inner, inner, ofInner }, { -inner, -inner, ofInner }, { outer, outer, ofOuter },
    { outer, -outer, ofOuter }, { -outer, outer, ofOuter }, { -outer, -outer, ofOuter } } };
}

}

const std::array<DiscPoint, ConeDirections>& DiscQuadrature()
{
  static const std::array<DiscPoint, ConeDirections> rule = MakeDiscQuadrature();
  return rule;
}

std::array<WeightedDirection, ConeDirections> DirectionsInCone(
  glm::dvec3 axis, double halfAngleRadians)
{
  const Tangents tangents = TangentsOf(axis);
  const double height = 1.0 - std::cos(halfAngleRadians);
  std::array<WeightedDirection, ConeDirections> directions;
  for (int i = 0; i < ConeDirections; ++i)
  {
    const DiscPoint& point = DiscQuadrature()[std::size_t(i)];
    const double along = 1.0 - height * (point.x * point.x + point.y * point.y);
    const double across = std::sqrt(height * (1.0 + along)); // per radius on the disc
    directions[std::size_t(i)] = {
      along * axis + across * (point.x * tangents.first + point.y * tangents.second), point.weight
    };
  }
  return directions;
}

}
