#ifndef Varimarch_Core_Blocks_BlockPartition_h
#define Varimarch_Core_Blocks_BlockPartition_h

#include "Core/Geometry/Box.h"
#include "Core/Geometry/ScalarGrid.h"

#include <glm/vec4.hpp>

#include <cstddef>
#include <vector>

namespace varimarch
{

/// Limits of a device for one block.
struct BlockLimits
{
  int largestSide; ///< largest side of a texture [voxels]
  std::size_t bytesPerVoxel;
  std::size_t largestBytes;
};

/// A division of a grid into blocks of cells, none of which exceeds a device's limits. Each cell is
/// in exactly one block. A block holds all voxels that positions in its cells read, including those
/// for central differences one voxel to either side. Neighbours therefore share three layers of
/// voxels, and values and gradients on their common face are the same from both sides.
class BlockPartition
{
public:
  /// An empty partition.
  BlockPartition() = default;

  /// The fewest blocks that the limits allow, with sides of about equal length.
  /// @throws std::runtime_error if the limits are below the smallest block
  BlockPartition(glm::ivec3 dimensions, const BlockLimits& limits);

  /// @return the size of the smallest possible block [bytes]
  static std::size_t SmallestBytes(std::size_t bytesPerVoxel);

  int Count() const { return this->count.x * this->count.y * this->count.z; }
  glm::ivec3 CellsPerBlock() const { return this->cellsPerBlock; }

  VoxelRegion VoxelsOf(int block) const;

  /// The cells of a block as a box. At the volume's faces it extends to `boxGrid`, the volume's
  /// box.
  Box BoxOf(int block, const Box& boxGrid) const;

  /// All blocks, each after those that lie in front of it as seen from an eye. A ray from the eye
  /// never approaches the eye's block on any axis, so the blocks are ordered by the sum of their
  /// distances to it along the axes.
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
