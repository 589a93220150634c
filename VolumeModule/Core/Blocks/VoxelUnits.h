#ifndef Varimarch_Core_Blocks_VoxelUnits_h
#define Varimarch_Core_Blocks_VoxelUnits_h

#include "Core/Blocks/BlockLevels.h"
#include "Core/Blocks/BrickSource.h"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace varimarch
{

/// The units in which the voxels of a volume in chunks come into memory, where they lie as in an
/// image, x fastest: whole chunks in rows along x. A unit has, in each of its slices, the pages of
/// memory that begin in its rows. The last of them may end in rows behind.
class VoxelUnits
{
public:
  /// @param level  one for which AreIn is true
  /// @param wantedBytes  units of fewer bytes have several chunks along y or z
  VoxelUnits(const BrickSource::Level& level, std::size_t voxelBytes, std::size_t pageBytes,
    double wantedBytes);

  /// True if a level has units.
  static bool AreIn(const BrickSource::Level& level, std::size_t voxelBytes, std::size_t pageBytes);

  std::size_t Count() const { return std::size_t(this->alongY * this->alongZ); }

  /// The unit of the page that begins at a byte.
  std::size_t UnitAt(std::uint64_t byte) const;

  /// The voxels in the rows of a unit.
  BrickSource::Box BoxOf(std::size_t unit) const;

  /// The rows behind those of a unit that its pages need, in as many slices, the first of which
  /// belongs to the unit's first slice; none if pages end with rows, or the volume ends.
  std::optional<BrickSource::Box> BoxBehind(std::size_t unit) const;

  /// Whole pages, from the first byte to before the last.
  struct Run
  {
    std::uint64_t begin;
    std::uint64_t end;
  };

  /// The pages of a unit in one of its slices, counted in the volume.
  Run RunOf(std::size_t unit, std::int64_t slice) const;

  /// Bytes of the first voxel of a row in the image.
  std::uint64_t ByteOfRow(std::int64_t row, std::int64_t slice) const
  {
    return this->rowBytes * std::uint64_t(slice * this->level.dimensions[1] + row);
  }

  std::uint64_t RowBytes() const { return this->rowBytes; }

  /// A bound of the bytes of a unit, with those of the rows behind.
  std::uint64_t MostBytes() const
  {
    return this->rowBytes * std::uint64_t((this->rows + 2 * this->rowsBehind) * this->slices);
  }

  /// A bound of the bytes of the units that blocks of voxels lie in.
  std::uint64_t MostBytesFor(const BlockLevels& levels) const;

private:
  std::int64_t FirstRow(std::size_t unit) const
  {
    return std::int64_t(unit) % this->alongY * this->rows;
  }
  std::int64_t RowBehind(std::size_t unit) const;

  BrickSource::Level level;
  std::uint64_t rowBytes;
  std::uint64_t pageBytes;
  std::int64_t rowsBehind; ///< rows that a page behind a row can reach into
  std::int64_t rows;       ///< rows of a unit, but for the last along y
  std::int64_t slices;     ///< slices of a unit, but for the last along z
  std::int64_t alongY;     ///< units along y
  std::int64_t alongZ;
};

}

#endif
