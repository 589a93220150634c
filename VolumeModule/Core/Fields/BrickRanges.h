#ifndef Varimarch_Core_Fields_BrickRanges_h
#define Varimarch_Core_Fields_BrickRanges_h

#include "Core/Geometry/ScalarGrid.h"

#include <array>
#include <cstdint>
#include <vector>

namespace varimarch
{

/// Smallest and largest value of every brick of 4 x 4 x 4 cells: the part of an acceleration
/// structure that depends on the data only.
///
/// A brick of cells reads 5 x 5 x 5 voxels, its far faces included, so that the range holds for
/// every interpolated value in it; where values depend on voxels farther off, on those too. Ranges
/// are kept in 8 or 16 bits relative to the range of the whole volume, rounded outwards: exact for
/// 8 bit data and for integers that span less than 2^16.
class BrickRanges
{
public:
  static constexpr int CellsPerSide = 4;

  /// A range in steps: value = FirstValue() + step * ValuePerStep(). A brick that holds a value
  /// that is not finite has smallest > largest.
  struct Steps
  {
    std::uint16_t smallest;
    std::uint16_t largest;

    bool IsFinite() const { return this->smallest <= this->largest; }
  };

  /// No bricks.
  BrickRanges() = default;

  /// Bricks of a volume, with the values from first to last to be kept in steps.
  /// @param integers  whether all values are whole numbers
  BrickRanges(glm::ivec3 cellCount, double firstValue, double lastValue, bool integers);

  glm::ivec3 BrickCount() const { return this->brickCount; }
  double FirstValue() const { return this->firstValue; }
  double ValuePerStep() const { return this->valuePerStep; }
  int LastStep() const { return this->lastStep; } ///< which none exceeds

  /// @param brick  index, x fastest
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

private:
  glm::ivec3 brickCount = glm::ivec3(0);
  double firstValue = 0.0; ///< value of step 0
  double valuePerStep = 1.0;
  int lastStep = 0;
  // One of the two: 8 bits suffice for whole numbers that span less than 2^8.
  std::vector<std::array<std::uint8_t, 2>> narrow;
  std::vector<std::array<std::uint16_t, 2>> wide;
};

/// Reads the volume once, on all cores.
/// @param smallestValue, largestValue  range of the finite values of the grid
/// @param reachVoxels  how far beyond its cell a value depends on voxels: not for linear
///                     interpolation
template <class Scalar>
BrickRanges BuildBrickRanges(
  const ScalarGrid<Scalar>& grid, double smallestValue, double largestValue, int reachVoxels = 0);

}

#endif
