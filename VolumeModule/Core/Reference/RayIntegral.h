#ifndef Varimarch_Core_Reference_RayIntegral_h
#define Varimarch_Core_Reference_RayIntegral_h

#include "Core/Reference/ReferenceScene.h"

#include <glm/vec4.hpp>

#include <memory>

namespace varimarch
{

struct ReferenceColor
{
  glm::dvec4 rgba; ///< premultiplied
  double error;    ///< estimate of the largest error of a channel
};

/// The part of a ray that counts, and how long its parameter is.
struct MeasuredRay
{
  Ray grid;
  double mmPerParameter; ///< > 0
  Interval inside;       ///< finite, not empty

  double LengthMm() const { return (this->inside.exit - this->inside.enter) * mmPerParameter; }
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
