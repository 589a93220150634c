#ifndef Varimarch_Core_Geometry_CellWalk_h
#define Varimarch_Core_Geometry_CellWalk_h

#include "Core/Geometry/Box.h"

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <limits>

namespace varimarch
{

/// The part of a ray inside one cell of the integer lattice.
struct CellPart
{
  glm::ivec3 cell; ///< the cell that spans [cell, cell + 1]
  Interval t;      ///< never empty
};

/// Calls visit(part) for the cells along a ray, front to back, until it returns false. The method
/// is that of Amanatides and Woo, "A fast voxel traversal algorithm for ray tracing" (Eurographics
/// 1987), except that each face's parameter is computed directly, so that rounding errors do not
/// accumulate.
/// @param inside  the part to walk; finite, with coordinates in the range of int
template <class Visit>
void WalkCells(const Ray& ray, Interval inside, Visit visit)
{
  glm::ivec3 cell;
  glm::ivec3 step;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double start = ray.origin[axis] + inside.enter * ray.direction[axis];
    step[axis] = ray.direction[axis] < 0.0 ? -1 : 1;
    cell[axis] = int(std::floor(start));
  }
  const auto exit = [&](int axis)
  {
    const double face = step[axis] < 0 ? cell[axis] : cell[axis] + 1.0;
    return ray.direction[axis] == 0.0 ? std::numeric_limits<double>::infinity()
                                      : (face - ray.origin[axis]) / ray.direction[axis];
  };
  glm::dvec3 exits(exit(0), exit(1), exit(2));

  double t = inside.enter;
  while (t < inside.exit)
  {
    const int axis =
      exits.x <= exits.y ? (exits.x <= exits.z ? 0 : 2) : (exits.y <= exits.z ? 1 : 2);
    const double end = std::min(exits[axis], inside.exit);
    // Skips a cell that the ray only touches.
    if (t < end)
    {
      if (!visit(CellPart{ cell, { t, end } }))
      {
        return;
      }
      t = end;
    }
    cell[axis] += step[axis];
    exits[axis] = exit(axis);
  }
}

}

#endif
