#ifndef Varimarch_Core_Fields_VisibleBricks_h
#define Varimarch_Core_Fields_VisibleBricks_h

#include "Core/Fields/OpticalField.h"
#include "Core/Geometry/Box.h"

#include <glm/vec3.hpp>

#include <vector>

namespace varimarch
{

/// Which bricks of a field are not invisible: all that is kept of it when a device has the rest.
class VisibleBricks
{
public:
  VisibleBricks() = default;
  explicit VisibleBricks(const OpticalField& field);

  /// The smallest box of whole bricks that holds all that is visible in a part of the volume, cut
  /// at the part [grid space]; an empty box, whose lower is not below its upper, where nothing is.
  /// A brick at a face of the part reaches to the face.
  Box Bounds(const Box& partGrid) const;

private:
  glm::ivec3 brickCount = glm::ivec3(0);
  std::vector<bool> visible; ///< x fastest
};

/// The blocks of side^3 bricks that hold something visible and touch, with a face, one that does
/// not, or the outside: their numbers along each axis.
std::vector<glm::ivec3> VisibleHull(const OpticalField& field, int side);

}

#endif
