#ifndef Varimarch_Core_Fields_VisibleBricks_h
#define Varimarch_Core_Fields_VisibleBricks_h

#include "Core/Fields/OpticalField.h"
#include "Core/Geometry/Box.h"

#include <glm/vec3.hpp>

#include <vector>

namespace varimarch
{

/// A flag for each brick of a field that is visible: all that stays in main memory once a device
/// has the field.
class VisibleBricks
{
public:
  VisibleBricks() = default;
  explicit VisibleBricks(const OpticalField& field);

  /// The smallest box of whole bricks that contains everything visible in a part of the volume,
  /// clipped to the part [grid space]. A brick at a face of the part extends to that face. If
  /// nothing is visible, the box is empty: its lower corner is not below its upper corner.
  Box Bounds(const Box& partGrid) const;

private:
  int side = BrickRanges::CellsPerSide; ///< cells along each side of a brick
  glm::ivec3 brickCount = glm::ivec3(0);
  std::vector<bool> visible; ///< x fastest
};

/// Indices of the surface blocks: blocks of side^3 bricks that contain something visible and have a
/// face next to a block that does not, or to the outside.
std::vector<glm::ivec3> VisibleHull(const OpticalField& field, int side);

}

#endif
