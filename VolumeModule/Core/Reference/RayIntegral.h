#ifndef Varimarch_Core_Reference_RayIntegral_h
#define Varimarch_Core_Reference_RayIntegral_h

#include "Core/Reference/ReferenceScene.h"

#include <glm/vec4.hpp>

#include <memory>
#include <vector>

namespace varimarch
{

struct ReferenceColor
{
  glm::dvec4 rgba; ///< premultiplied
  double error;    ///< estimated largest error of a channel
};

/// A ray in grid space with the parts of it that count, and the length of its parameter.
struct MeasuredRay
{
  Ray grid;
  double mmPerParameter;       ///< > 0
  std::vector<Interval> parts; ///< front to back; each finite, not empty

  /// Length from the beginning of the first part to the end of the last.
  double LengthMm() const
  {
    return (this->parts.back().exit - this->parts.front().enter) * this->mmPerParameter;
  }
  glm::dvec3 PositionGrid(double t) const { return this->grid.origin + t * this->grid.direction; }
};

/// The integral along a ray for one blend mode, to a tolerance. Each blend mode has its class.
class RayIntegral
{
public:
  virtual ~RayIntegral() = default;
  virtual ReferenceColor Along(const MeasuredRay& ray) const = 0;
};

/// Creates the integral for the scene's blend mode.
/// @throws std::invalid_argument for slices, which have none
std::unique_ptr<const RayIntegral> NewRayIntegral(ReferenceScene scene, double tolerance);

}

#endif
