#ifndef Varimarch_Core_Fields_FieldDirections_h
#define Varimarch_Core_Fields_FieldDirections_h

#include "Core/Geometry/PixelRays.h"

#include <glm/vec3.hpp>

#include <optional>

namespace varimarch
{

/// The direction of a frame's rays along each axis of the grid: 1 or -1 if all rays agree, or 0
/// if they do not or hardly move along this axis.
glm::ivec3 DirectionsOf(const PixelRays& rays);

/// Chooses the directions for which a field is measured, from frame to frame. If rays leave
/// these directions, the field is measured for both ways along that axis. It is measured for fewer
/// directions only after they have not changed for a while, so that two alternating views, as of
/// two eyes, share one field.
class FieldDirections
{
public:
  /// @param rays  DirectionsOf the next frame
  /// @return the directions for which its field must be measured
  glm::ivec3 Next(glm::ivec3 rays);

private:
  std::optional<glm::ivec3> measured; ///< empty until the first frame
  glm::ivec3 last = glm::ivec3(0);
  int kept = 0; ///< number of frames for which `last` has not changed
};

}

#endif
