#ifndef Varimarch_Core_Blocks_BlockLevels_h
#define Varimarch_Core_Blocks_BlockLevels_h

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace varimarch
{

/// The level by which a block is drawn: 0 for the voxels, 1 for the finest coarser level, and so
/// on. Rays pass a block of level Nothing, whose voxels are invisible, so that none of them is
/// read, not even at its faces.
enum class BlockLevel : std::uint8_t
{
  Voxels,
  Coarse, ///< the finest coarser level
  Nothing = 255,
};

/// True for blocks that are drawn by a level other than the voxels.
inline bool IsCoarse(BlockLevel level)
{
  return level != BlockLevel::Voxels && level != BlockLevel::Nothing;
}

/// The next finer level of a coarse one.
inline BlockLevel FinerThan(BlockLevel level)
{
  return BlockLevel(std::uint8_t(level) - 1);
}

/// The level of each block of bricks of a volume.
struct BlockLevels
{
  int side = 1;                     ///< cells along each side of a block
  glm::ivec3 count = glm::ivec3(0); ///< blocks along each axis
  std::vector<BlockLevel> ofBlocks; ///< x fastest

  /// The place of a block in `ofBlocks`; outside the volume, that of the nearest block.
  std::size_t PlaceOf(const glm::ivec3& block) const
  {
    const glm::ivec3 inside = glm::clamp(block, glm::ivec3(0), this->count - 1);
    return (std::size_t(inside.z) * this->count.y + inside.y) * this->count.x + inside.x;
  }
};

}

#endif
