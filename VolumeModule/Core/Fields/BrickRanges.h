#ifndef Varimarch_Core_Fields_BrickRanges_h
#define Varimarch_Core_Fields_BrickRanges_h

#include "Core/Geometry/ScalarGrid.h"
#include "Core/Geometry/UnevenAxis.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace varimarch
{

/// Smallest and largest value of each brick of cells: the part of an acceleration structure that
/// depends only on the data. Bricks have 4 x 4 x 4 cells; those of volumes on disk have more where
/// so many of them would not fit into memory.
///
/// A brick of 4 x 4 x 4 cells reads 5 x 5 x 5 voxels, including its far faces, so that its range
/// holds for all interpolated values in it; an interpolation that depends on voxels farther away
/// adds those.
/// Ranges are stored in 8 or 16 bits relative to a range of values, rounded outwards; values beyond
/// its ends count as these. They are exact for 8 bit data and for integers that span less than
/// 2^16.
class BrickRanges
{
public:
  static constexpr int CellsPerSide = 4; ///< the side in volumes in memory

  /// A range in steps: value = FirstValue() + step * ValuePerStep(). A brick with a value that is
  /// not finite has smallest > largest.
  struct Steps
  {
    std::uint16_t smallest;
    std::uint16_t largest;

    bool IsFinite() const { return this->smallest <= this->largest; }
  };

  /// An object without bricks.
  BrickRanges() = default;

  /// Bricks of a volume whose values between first and last are told apart.
  /// @param integers  true if all values are whole numbers
  /// @param side      cells along each side of a brick
  BrickRanges(glm::ivec3 cellCount, double firstValue, double lastValue, bool integers,
    int side = CellsPerSide);

  int Side() const { return this->side; } ///< cells along each side of a brick

  glm::ivec3 BrickCount() const { return this->brickCount; }
  double FirstValue() const { return this->firstValue; }
  double ValuePerStep() const { return this->valuePerStep; }
  int LastStep() const { return this->lastStep; } ///< the largest step

  /// @param brick  linear index, x fastest
  Steps operator[](std::size_t brick) const
  {
    return this->narrow.empty() ? Steps{ this->wide[brick][0], this->wide[brick][1] }
                                : Steps{ this->narrow[brick][0], this->narrow[brick][1] };
  }
  void Set(std::size_t brick, Steps steps);

  std::size_t Bytes() const
  {
    return this->narrow.size() * sizeof(this->narrow[0]) +
      this->wide.size() * sizeof(this->wide[0]);
  }

  /// The steps of all bricks as they are in memory, `Bytes()` long, to be stored and restored.
  void* Memory()
  {
    return this->narrow.empty() ? static_cast<void*>(this->wide.data()) : this->narrow.data();
  }
  const void* Memory() const { return const_cast<BrickRanges*>(this)->Memory(); }

private:
  int side = CellsPerSide;
  glm::ivec3 brickCount = glm::ivec3(0);
  double firstValue = 0.0; ///< value of step 0
  double valuePerStep = 1.0;
  int lastStep = 0;
  // Only one of these is used: 8 bits suffice for integers that span less than 2^8.
  std::vector<std::array<std::uint8_t, 2>> narrow;
  std::vector<std::array<std::uint16_t, 2>> wide;
};

/// Builds the ranges by reading the volume once, on all cores.
/// @param smallestValue, largestValue  range of the values that are told apart: all finite values
/// of the grid, or those between which its look changes
/// @param reachVoxels  number of voxels beyond its cell that an interpolated value depends on; 0
/// for linear interpolation
/// @param side  cells along each side of a brick
template <class Scalar>
BrickRanges BuildBrickRanges(const ScalarGrid<Scalar>& grid, double smallestValue,
  double largestValue, int reachVoxels = 0, int side = BrickRanges::CellsPerSide);

/// The range of the values of two bricks, or of two parts of a brick.
inline BrickRanges::Steps Union(const BrickRanges::Steps& a, const BrickRanges::Steps& b)
{
  if (!a.IsFinite() || !b.IsFinite())
  {
    return { 1, 0 };
  }
  return { std::min(a.smallest, b.smallest), std::max(a.largest, b.largest) };
}

/// Brick ranges on the even grid of a rectilinear volume, in which rays are straight. Each even
/// brick has the range of all voxel bricks that overlap it; outermost ones include everything
/// beyond.
/// @param ofVoxels  ranges of the bricks of voxels; at least one brick
/// @param axes  the three axes
BrickRanges EvenBricks(const BrickRanges& ofVoxels, const std::vector<UnevenAxis>& axes);

}

#endif
