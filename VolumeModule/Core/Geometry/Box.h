#ifndef Varimarch_Core_Geometry_Box_h
#define Varimarch_Core_Geometry_Box_h

#include <glm/vec3.hpp>

#include <algorithm>
#include <limits>
#include <utility>

namespace varimarch
{

/// A half-line origin + t * direction, t >= 0. All of it in one space, which the owner names.
struct Ray
{
  glm::dvec3 origin;
  glm::dvec3 direction; ///< any length but zero; t counts in units of this length
};

/// The part of a ray between two of its parameters; empty when exit <= enter.
struct Interval
{
  double enter;
  double exit;

  bool IsEmpty() const { return !(enter < exit); }
};

/// An axis-aligned box, closed; lower <= upper on every axis.
struct Box
{
  glm::dvec3 lower;
  glm::dvec3 upper;
};

/// The part of `ray` inside `box`, no larger than `limits`.
/// Slab test of Kay and Kajiya (SIGGRAPH 1986). A direction component of zero is decided by
/// comparison, not by division, so that a ray in the plane of a face never makes a NaN.
inline Interval Intersection(const Ray& ray, const Box& box,
  Interval limits = { 0.0, std::numeric_limits<double>::infinity() })
{
  const Interval nothing{ 0.0, 0.0 };
  for (int axis = 0; axis < 3; ++axis)
  {
    const double origin = ray.origin[axis];
    const double direction = ray.direction[axis];
    if (direction == 0.0)
    {
      if (!(origin >= box.lower[axis] && origin <= box.upper[axis]))
      {
        return nothing;
      }
      continue;
    }
    double nearer = (box.lower[axis] - origin) / direction;
    double farther = (box.upper[axis] - origin) / direction;
    if (nearer > farther)
    {
      std::swap(nearer, farther);
    }
    limits.enter = std::max(limits.enter, nearer);
    limits.exit = std::min(limits.exit, farther);
  }
  return limits.IsEmpty() ? nothing : limits;
}

}

#endif
