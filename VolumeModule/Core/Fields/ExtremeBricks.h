#ifndef Varimarch_Core_Fields_ExtremeBricks_h
#define Varimarch_Core_Fields_ExtremeBricks_h

#include "Core/Fields/BrickRanges.h"
#include "Core/Look/OpticalTable.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace varimarch
{

/// The look of extreme values: a transfer function, applied over one unit distance.
struct ExtremeLook
{
  const OpticalTable& table;
  double opacityUnitDistanceMm;
  double tolerance; ///< accepted error of a premultiplied channel of a pixel
};

/// For a maximum: for each brick (x fastest), the least value, in steps of its range, that looks
/// like the brick's largest value. A ray that has already found this value need not enter the
/// brick, since no value there would change the pixel by more than the tolerance. For a minimum:
/// the greatest value that looks like the brick's smallest. A brick with a value that is not finite
/// must always be entered.
/// @param largest  true for a maximum
std::vector<std::uint16_t> BuildExtremeBricks(
  const BrickRanges& ranges, const ExtremeLook& look, bool largest);

/// The same bound for blocks of bricks: a ray that has found this value may skip the whole block.
struct ExtremeBlocks
{
  static constexpr int BricksPerSide = 4;

  glm::ivec3 count = glm::ivec3(0);
  std::vector<std::uint16_t> steps; ///< x fastest
};

/// @param bricks  the result of BuildExtremeBricks
ExtremeBlocks JoinExtremeBricks(
  const std::vector<std::uint16_t>& bricks, glm::ivec3 brickCount, bool largest);

}

#endif
