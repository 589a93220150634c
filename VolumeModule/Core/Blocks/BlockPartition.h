#ifndef Varimarch_Core_Blocks_BlockPartition_h
#define Varimarch_Core_Blocks_BlockPartition_h

#include "Core/Geometry/Box.h"
#include "Core/Geometry/ScalarGrid.h"

#include <glm/vec4.hpp>

#include <cstddef>
#include <map>
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

/// Decides which blocks of a volume stay in a memory that may be too small for all of them. The
/// caller creates and frees the textures.
///
/// The next frame is expected to use the same blocks in the same order. The block whose next use
/// is farthest in the future is evicted first (Belady, "A study of replacement algorithms for a
/// virtual-storage computer", 1966): first blocks outside the frame, least recently used first,
/// then the block that this frame has used last. Evicting the frame's own least recently used
/// block would be the worst choice: its turn comes next, and no block would ever be found in
/// memory.
class BlockResidency
{
public:
  /// @param order  the blocks of the frame that begins, in order of use
  void BeginPicture(const std::vector<int>& order);

  /// Records that the next block of the order is used and held.
  /// @param bytes  size of the block
  /// @return the blocks to evict before, so that at most `capacity` bytes are held
  /// @throws std::runtime_error if the block alone is larger than `capacity`
  std::vector<int> Use(int block, std::size_t bytes, std::size_t capacity);

  /// @return the blocks to evict, so that at most `capacity` bytes are held
  std::vector<int> Shrink(std::size_t capacity);

  bool Holds(int block) const { return this->held.count(block) > 0; }
  std::size_t Bytes() const;
  void Clear();

private:
  std::size_t NextUse(int block) const;

  struct Held
  {
    std::size_t bytes;
    std::size_t lastUse; ///< value of `time` at that use
  };
  std::map<int, Held> held;
  std::map<int, std::size_t> positions; ///< position of each of the frame's blocks in its order
  std::size_t position = 0;             ///< position of the next use in the frame's order
  std::size_t time = 0;                 ///< number of uses so far, in all frames
};

}

#endif
