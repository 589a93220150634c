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
struct BlockLevels
{
  int side = 1;                        ///< bricks along a side of a block
  glm::ivec3 count = glm::ivec3(0);    ///< blocks along each axis
  std::vector<std::uint8_t> areVoxels; ///< 1 for voxels, 0 for the coarse level; x fastest

  /// The place of a block in `areVoxels`; outside the volume, that of the nearest block.
  std::size_t PlaceOf(const glm::ivec3& block) const
  {
    const glm::ivec3 inside = glm::clamp(block, glm::ivec3(0), this->count - 1);
    return (std::size_t(inside.z) * this->count.y + inside.y) * this->count.x + inside.x;
  }
};

}

#endif
