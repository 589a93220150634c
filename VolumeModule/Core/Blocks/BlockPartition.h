#ifndef Varimarch_Core_Blocks_BlockPartition_h
#define Varimarch_Core_Blocks_BlockPartition_h

#include "Core/Geometry/Box.h"
#include "Core/Geometry/ScalarGrid.h"

#include <glm/vec4.hpp>

#include <cstddef>
#include <vector>

namespace varimarch
{

/// What a block may take of a device.
struct BlockLimits
{
  int largestSide; ///< of a texture [voxels]
  std::size_t bytesPerVoxel;
  std::size_t largestBytes;
};

/// A grid cut into blocks of cells, none of them too large for a device: each cell is in one block.
/// A block holds all voxels that a position in its cells reads, also for central differences one
/// voxel to either side: neighbours share three layers of voxels, so that values and gradients at
/// their common face are the same from both sides.
class BlockPartition
{
public:
  /// No blocks.
  BlockPartition() = default;

  /// As few blocks as the limits allow, of about equal sides.
  /// @throws std::runtime_error when the limits do not allow the smallest block
  BlockPartition(glm::ivec3 dimensions, const BlockLimits& limits);

  /// @return the bytes that the smallest block may have
  static std::size_t SmallestBytes(std::size_t bytesPerVoxel);

  int Count() const { return this->count.x * this->count.y * this->count.z; }
  glm::ivec3 CellsPerBlock() const { return this->cellsPerBlock; }

  VoxelRegion VoxelsOf(int block) const;

  /// The cells of a block; at a face of the volume it reaches to the face of `boxGrid`, the
  /// volume's box.
  Box BoxOf(int block, const Box& boxGrid) const;

  /// Every block, none before another that lies in front of it for an eye. A ray from the eye moves
  /// away from the eye's block on each axis, or stays: so order by the sum of these distances.
  /// @param eyeGrid  see PixelRays
  std::vector<int> FrontToBack(const glm::dvec4& eyeGrid) const;

  bool operator==(const BlockPartition& other) const
  {
    return this->dimensions == other.dimensions && this->cellsPerBlock == other.cellsPerBlock;
  }

private:
  glm::ivec3 IndexOf(int block) const;
  bool Fits(const BlockLimits& limits) const;
  void CutAlong(int axis);

  glm::ivec3 dimensions = glm::ivec3(0);
  glm::ivec3 cellCount = glm::ivec3(0);
  glm::ivec3 cellsPerBlock = glm::ivec3(0);
  glm::ivec3 count = glm::ivec3(0);
};

}

#endif
