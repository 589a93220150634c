#ifndef Varimarch_Core_Geometry_Box_h
#define Varimarch_Core_Geometry_Box_h

#include <glm/vec3.hpp>

#include <algorithm>
#include <limits>
#include <utility>

namespace varimarch
{

/// A half-line origin + t * direction, t >= 0, in the space that its owner names.
struct Ray
{
  glm::dvec3 origin;
  glm::dvec3 direction; ///< not zero; t counts in units of its length
};

/// A range of ray parameters; empty if exit <= enter.
struct Interval
{
  double enter;
  double exit;

  bool IsEmpty() const { return !(enter < exit); }
};

/// An axis-aligned box including its faces; lower <= upper on each axis.
struct Box
{
  glm::dvec3 lower;
  glm::dvec3 upper;
};

/// The part of `ray` inside `box` and within `limits`, by the slab test of Kay and Kajiya (SIGGRAPH
/// 1986). A zero direction component is handled by comparison instead of division, so that a ray in
/// the plane of a face never makes a NaN.
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
