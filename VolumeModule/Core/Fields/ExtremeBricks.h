#ifndef Varimarch_Core_Fields_ExtremeBricks_h
#define Varimarch_Core_Fields_ExtremeBricks_h

#include "Core/Fields/BrickRanges.h"
#include "Core/Look/TransferFunction.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace varimarch
{

/// How extremes are seen: the value found along a ray, through a transfer function over one unit
/// distance.
struct ExtremeLook
{
  const OpticalTable& table;
  double opacityUnitDistanceMm;
  double tolerance; ///< that a premultiplied channel of the picture may be off
};

/// For each brick, x fastest, in steps of its range, the least value that is as good as its
/// largest: a ray that has found as much need not enter the brick for a maximum, since nothing
/// there would change the picture by more than the tolerance. For a minimum, the greatest value
/// that is as good as its smallest. In a brick with a value that is not finite there may be any
/// other.
/// @param largest  for a maximum
std::vector<std::uint16_t> BuildExtremeBricks(
  const BrickRanges& ranges, const ExtremeLook& look, bool largest);

/// The same of blocks of bricks: what a ray must have found to leave all of one out.
struct ExtremeBlocks
{
  static constexpr int BricksPerSide = 4;

  glm::ivec3 count = glm::ivec3(0);
  std::vector<std::uint16_t> steps; ///< x fastest
};

/// @param bricks  of BuildExtremeBricks
ExtremeBlocks JoinExtremeBricks(
  const std::vector<std::uint16_t>& bricks, glm::ivec3 brickCount, bool largest);

}

#endif
