#ifndef Varimarch_Core_Blocks_BlockLevels_h
#define Varimarch_Core_Blocks_BlockLevels_h

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace varimarch
{

/// The level by which each block of bricks of a volume is drawn: its voxels or the coarse level.
/// Rays pass a block without anything visible, so that none of its voxels is read, not even at its
/// faces.
struct BlockLevels
{
  int side = 1;                     ///< bricks along a side of a block
  glm::ivec3 count = glm::ivec3(0); ///< blocks along each axis
  /// 1 for voxels, 0 for the coarse level, Nothing for blocks whose voxels are invisible; x
  /// fastest.
  std::vector<std::uint8_t> areVoxels;

  static constexpr std::uint8_t Nothing = 2;

  /// The place of a block in `areVoxels`; outside the volume, that of the nearest block.
  std::size_t PlaceOf(const glm::ivec3& block) const
  {
    const glm::ivec3 inside = glm::clamp(block, glm::ivec3(0), this->count - 1);
    return (std::size_t(inside.z) * this->count.y + inside.y) * this->count.x + inside.x;
  }
};

}

#endif
