#ifndef Varimarch_Core_Quality_BlockLooks_h
#define Varimarch_Core_Quality_BlockLooks_h

#include "Core/Blocks/BlockLevels.h"
#include "Core/Fields/VolumeSummary.h"
#include "Core/Look/OpticalTable.h"

#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>
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

/// Bounds of what rays meet in blocks of bricks of a volume, in its voxels and in its coarse level.
/// They need no voxel: those of the voxels follow from the ranges of the block's bricks, those of
/// the level from the means that it is interpolated from.
class BlockLooks
{
public:
  /// @param type       that of the volume, which has a coarse level
  /// @param brightest  the largest number that light makes of a colour, which may be any from 0 to
  ///                   it; none if light changes no colours
  BlockLooks(const VolumeSummary& summary, VoxelType type, const OpticalTable& table,
    std::optional<double> brightest);

  /// Every block by the coarse level.
  const BlockLevels& Coarse() const { return this->coarse; }

  /// Nothing of blocks without anything visible in their voxels; all others by the coarse level.
  BlockLevels Begun() const;

  /// Bounds in the voxels of a block; cells without a value are clear.
  /// @param place  see BlockLevels
  LookBetween OfVoxels(std::size_t place) const
  {
    return this->LookOf(this->blocks[place].voxels, this->blocks[place].hasGaps);
  }
  /// Bounds in the voxels and in the coarse level of a block.
  LookBetween OfBoth(std::size_t place) const
  {
    return this->LookOf(this->blocks[place].both, this->blocks[place].hasGaps);
  }

  /// True if the level, where it is drawn alone, ends in a block: at its outermost means, before
  /// the faces of the volume.
  bool LevelEndsIn(const glm::ivec3& block) const;

  double CellsPerSide() const { return double(this->coarse.side) * BrickRanges::CellsPerSide; }

private:
  /// Entries of the table.
  struct Entries
  {
    std::int32_t first;
    std::int32_t last;
  };

  static Entries Around(const Entries& one, const Entries& other);

  struct Block
  {
    Entries voxels;
    Entries both;
    bool hasGaps;
  };

  template <class Scalar>
  void FindEntries(const VolumeSummary& summary, const OpticalTable& table);
  LookBetween LookOf(const Entries& entries, bool hasGaps) const;

  EntryExtremes extremes;
  std::optional<double> brightest;
  glm::ivec3 lastMeans; ///< the block of the last means along each axis
  BlockLevels coarse;
  std::vector<Block> blocks;
};

}

#endif
