#ifndef Varimarch_Core_Quality_BlockLooks_h
#define Varimarch_Core_Quality_BlockLooks_h

#include "Core/Blocks/BlockLevels.h"
#include "Core/Fields/VolumeSummary.h"
#include "Core/Look/OpticalTable.h"

#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace varimarch
{

/// Bounds of colour and extinction [1/mm].
struct LookBetween
{
  glm::vec4 least = glm::vec4(0.0f);
  glm::vec4 most = glm::vec4(0.0f);
};

/// Bounds of the entries of a table in any interval, found in two overlapping ones whose lengths
/// are powers of two.
class EntryExtremes
{
public:
  explicit EntryExtremes(const std::vector<glm::vec4>& entries);
  LookBetween Of(int first, int last) const;

private:
  std::vector<std::vector<LookBetween>> levels;
};

/// A level between the voxels and the coarse level of a summary, which is interpolated from voxels
/// of its own: voxel (i, j, k) is at first + scale * (i, j, k) in the grid of the volume.
struct MiddleLevel
{
  std::shared_ptr<const VolumeSummary> summary; ///< that of its voxels, of the volume's type
  glm::dvec3 first;
  glm::dvec3 scale;
};

/// Bounds of what rays meet in blocks of bricks of a volume, in its voxels and in its coarser
/// levels. They need no voxel: those of the voxels and of middle levels follow from the ranges of
/// bricks in the block, those of the coarsest level from the means that it is interpolated from.
class BlockLooks
{
public:
  /// @param type       that of the volume, which has a coarse level
  /// @param brightest  the largest number that light makes of a colour, which may be any from 0 to
  ///                   it; none if light changes no colours
  /// @param middle     the levels between, from the finest on
  BlockLooks(const VolumeSummary& summary, VoxelType type, const OpticalTable& table,
    std::optional<double> brightest, const std::vector<MiddleLevel>& middle = {});

  /// Every block by the coarsest level.
  const BlockLevels& Coarse() const { return this->coarse; }

  /// Nothing of blocks without anything visible in their voxels; all others by the coarsest level.
  BlockLevels Begun() const;

  /// Bounds in the voxels of a block; cells without a value are clear.
  /// @param place  see BlockLevels
  LookBetween OfVoxels(std::size_t place) const { return this->UpTo(BlockLevel::Voxels, place); }

  /// Bounds in the voxels of a block and in its levels up to one, so that those of finer levels are
  /// never wider.
  LookBetween UpTo(BlockLevel level, std::size_t place) const
  {
    return this->LookOf(
      this->entries[place * this->levelCount + std::size_t(level)], this->hasGaps[place] != 0);
  }

  /// True if the level, where it is drawn alone, ends in a block: at its outermost means, before
  /// the faces of the volume.
  bool LevelEndsIn(const glm::ivec3& block) const;

  double CellsPerSide() const { return double(this->coarse.side); }

private:
  /// Entries of the table.
  struct Entries
  {
    std::int32_t first;
    std::int32_t last;
  };

  class EntriesBetween;

  static Entries Around(const Entries& one, const Entries& other);

  template <class Scalar>
  void FindEntries(const VolumeSummary& summary, const OpticalTable& table,
    const std::vector<MiddleLevel>& middle);
  LookBetween LookOf(const Entries& between, bool hasGap) const;

  EntryExtremes extremes;
  std::optional<double> brightest;
  glm::ivec3 lastMeans; ///< the block of the last means along each axis
  BlockLevels coarse;
  std::size_t levelCount;            ///< with the voxels
  std::vector<Entries> entries;      ///< table entries of each block, up to each level
  std::vector<std::uint8_t> hasGaps; ///< not 0 for blocks with cells without a value
};

}

#endif
