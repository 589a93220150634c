#ifndef Varimarch_Core_Fields_BrickRows_h
#define Varimarch_Core_Fields_BrickRows_h

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace varimarch
{

/// The rows of a mask that occur in each brick of a volume (see BrickRanges): which of the look's
/// functions a brick can show. Most bricks share one of few sets of rows.
class BrickRows
{
public:
  /// Bricks of a volume without a mask, or whose rows are not known: each may have every row.
  BrickRows() = default;

  /// @param rows        the row of each voxel of the mask, x fastest, which fills the box around
  ///                    its voxel; all of them fill the volume's box
  /// @param maskSize    the number of the mask's voxels along each axis
  /// @param voxelCount  the number of the volume's voxels along each axis
  BrickRows(const std::vector<std::uint16_t>& rows, glm::ivec3 maskSize, glm::ivec3 voxelCount);

  bool AreKnown() const { return !this->setOfBrick.empty(); }

  /// The different sets of rows, ascending; empty if none is known.
  const std::vector<std::vector<std::uint16_t>>& Sets() const { return this->sets; }

  /// The number of a brick's set.
  /// @param brick  linear index, x fastest
  std::size_t SetOf(std::size_t brick) const { return this->setOfBrick[brick]; }

private:
  std::vector<std::vector<std::uint16_t>> sets;
  std::vector<std::uint32_t> setOfBrick;
};

/// Extent of the label around each voxel v of a mask: k + 1 if all voxels v - k ... v + k on each
/// axis, clipped to the mask, have the same label. Exact up to 255.
/// @param labels  x fastest
std::vector<std::uint16_t> LabelReach(const std::vector<std::uint16_t>& labels, glm::ivec3 size);

}

#endif
