#ifndef Varimarch_Core_Fields_FieldDirections_h
#define Varimarch_Core_Fields_FieldDirections_h

#include "Core/Geometry/PixelRays.h"

#include <glm/vec3.hpp>

#include <optional>

namespace varimarch
{

/// Which way along each axis of the grid all rays of a picture go: 1, -1, or 0 where some go the
/// one way and some the other, or hardly any.
glm::ivec3 DirectionsOf(const PixelRays& rays);

/// The directions that a field is measured towards, from picture to picture. One that is turned
/// into other directions is measured again for both, and for fewer only when the view has kept them
/// for a while: two views in turn, as of two eyes, then have one field.
class FieldDirections
{
public:
  /// @param rays  DirectionsOf the next picture
  /// @return what its field must be measured towards
  glm::ivec3 Next(glm::ivec3 rays);

private:
  std::optional<glm::ivec3> measured; ///< none: nothing has been drawn
  glm::ivec3 last = glm::ivec3(0);
  int kept = 0; ///< how many pictures the last directions have been the same
};

}

#endif
