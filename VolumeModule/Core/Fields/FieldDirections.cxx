#include "Core/Fields/FieldDirections.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

// Number of frames with unchanged directions after which no change is expected soon.
constexpr int Settled = 8;

}

glm::ivec3 DirectionsOf(const PixelRays& rays)
{
  glm::ivec3 directions(0);
  for (int axis = 0; axis < 3; ++axis)
  {
    // Includes rays away from the centres of the outermost pixels.
    constexpr double Edge = 1.1;
    const double middle = rays.directionGrid[0][axis];
    const double reach =
      Edge * (std::abs(rays.directionGrid[1][axis]) + std::abs(rays.directionGrid[2][axis]));
    // Large enough that rounding cannot reverse a direction.
    const double least = 1e-4 * glm::length(rays.directionGrid[0]);
    directions[axis] = std::abs(middle) - reach > least ? (middle > 0.0 ? 1 : -1) : 0;
  }
  return directions;
}

glm::ivec3 FieldDirections::Next(glm::ivec3 rays)
{
  this->kept = this->measured && this->last == rays ? this->kept + 1 : 0;
  this->last = rays;
  if (!this->measured || this->kept >= Settled)
  {
    this->measured = rays;
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    if ((*this->measured)[axis] != rays[axis])
    {
      (*this->measured)[axis] = 0;
    }
  }
  return *this->measured;
}

}
