#ifndef Varimarch_Core_Fields_VolumeSummary_h
#define Varimarch_Core_Fields_VolumeSummary_h

#include "Core/Blocks/BrickSource.h"
#include "Core/Fields/BrickRanges.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace varimarch
{

/// A level of a volume whose voxels are means of cubes of voxels, of the same type: voxel (i, j, k)
/// is at Side * (i, j, k) + (Side - 1) / 2 in the grid of the volume. Cubes that the volume cuts
/// are left out.
struct CoarseLevel
{
  static constexpr int Side = BrickRanges::CellsPerSide;

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
/// @param smallest, largest  finite values; ranges of a type of 8 or 16 bits do not depend on them
VolumeSummary UnfilledSummary(
  const BrickSource::Level& level, VoxelType type, double smallest, double largest);

/// True if the ranges of whole numbers tell that all voxels of a box are 0.
bool AreZero(const BrickRanges& ranges, const BrickSource::Box& box);

/// Memory of the ranges and of the field of a volume, with what is needed to build them [bytes].
std::uint64_t BytesOfBricks(const BrickSource::Level& level, VoxelType type);

/// Reads what is stored of level 0 slab by slab, on all cores: once, or twice for floats.
/// @param mostSlabBytes  voxels that are in memory at the same time [bytes]
/// @param report  receives the finished part, [0, 1], in the calling thread; may throw to stop
VolumeSummary SummaryOf(const BrickSource& source, std::uint64_t mostSlabBytes,
  const std::function<void(double)>& report);

}

#endif
