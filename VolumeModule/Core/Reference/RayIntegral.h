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
  double error;    ///< estimate of the largest error of a channel
};

/// The parts of a ray that count, and how long its parameter is.
struct MeasuredRay
{
  Ray grid;
  double mmPerParameter;       ///< > 0
  std::vector<Interval> parts; ///< front to back; each finite, not empty

  /// From the beginning of the first part to the end of the last.
  double LengthMm() const
  {
    return (this->parts.back().exit - this->parts.front().enter) * this->mmPerParameter;
  }
  glm::dvec3 PositionGrid(double t) const { return this->grid.origin + t * this->grid.direction; }
};

/// What one blend mode makes of a ray, to a tolerance; one class, and one file, for each mode.
class RayIntegral
{
public:
  virtual ~RayIntegral() = default;
  virtual ReferenceColor Along(const MeasuredRay& ray) const = 0;
};

/// The one for the scene's blend mode.
std::unique_ptr<const RayIntegral> NewRayIntegral(ReferenceScene scene, double tolerance);

}

#endif
