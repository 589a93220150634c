#ifndef Varimarch_Core_Fields_VolumeSummary_h
#define Varimarch_Core_Fields_VolumeSummary_h

#include "Core/Blocks/BrickSource.h"
#include "Core/Fields/BrickRanges.h"
#include "Core/Look/ValueRange.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace varimarch
{

/// A level of a volume whose voxels are means of cubes of voxels, of the same type: voxel (i, j, k)
/// is at side * (i, j, k) + (side - 1) / 2 in the grid of the volume. Cubes that the volume cuts
/// are left out.
struct CoarseLevel
{
  /// Voxels along each side of a cube, as many as a brick has cells.
  int side = BrickRanges::CellsPerSide;
  glm::ivec3 voxelCount = glm::ivec3(0); ///< 0 if the volume is too thin
  std::vector<std::uint8_t> voxels;      ///< as bytes, x fastest
};

/// The facts about a whole volume that must be known before it is drawn, for volumes of which only
/// parts are ever in memory, so that they are read once only.
struct VolumeSummary
{
  double smallest = 0.0; ///< smallest finite value; 0 if there is none
  double largest = 0.0;  ///< largest finite value; 0 if there is none
  bool areFinite = true; ///< true if all values are finite
  BrickRanges ranges;    ///< told apart over all finite values, or all values of a narrow type
  /// The number of voxels of each value of a type of 8 or 16 bits, from the type's smallest to its
  /// largest; empty for other types.
  std::vector<std::int64_t> counts;
  CoarseLevel coarse;
};

/// A summary with memory for all its members.
/// @param extremes  the smallest and the largest finite value; ranges of a type of 8 or 16 bits do
/// not depend on them
/// @param side  cells along each side of a brick
VolumeSummary UnfilledSummary(
  const BrickSource::Level& level, VoxelType type, const ValueRange& extremes, int side);

/// True if the ranges of whole numbers tell that all voxels of a box are 0.
bool AreZero(const BrickRanges& ranges, const BrickSource::Box& box);

/// Memory of the ranges and of the field of a volume, with what is needed to build them [bytes].
/// @param side  cells along each side of a brick
std::uint64_t BytesOfBricks(const BrickSource::Level& level, VoxelType type, int side);

/// The side of bricks that need at most some memory: 4, 8, 16 or 32 cells, the least of them that
/// serves; 32 if none does.
int SideOfBricks(const BrickSource::Level& level, VoxelType type, std::uint64_t mostBytes);

/// The way in which a summary is made.
struct SummaryOptions
{
  std::uint64_t mostSlabBytes;          ///< voxels that are in memory at the same time [bytes]
  int side = BrickRanges::CellsPerSide; ///< cells along each side of a brick
};

/// Reads what is stored of level 0 slab by slab, on all cores: once, or twice for floats.
/// @param report  receives the finished part, [0, 1], in the calling thread; may throw to stop
VolumeSummary SummaryOf(const BrickSource& source, const SummaryOptions& options,
  const std::function<void(double)>& report);

}

#endif
