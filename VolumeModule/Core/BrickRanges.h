#ifndef Varimarch_Core_BrickRanges_h
#define Varimarch_Core_BrickRanges_h

#include "Core/ScalarGrid.h"

#include <cstdint>
#include <vector>

namespace varimarch
{

/// Smallest and largest value of every brick of 4 x 4 x 4 cells: the part of an acceleration
/// structure that depends on the data only.
///
/// A brick of cells reads 5 x 5 x 5 voxels, its far faces included, so that the range holds for
/// every interpolated value in it. Ranges are kept in 16 bits relative to the range of the whole
/// volume, rounded outwards: exact for 8 bit data and for integers that span less than 2^16.
struct BrickRanges
{
  static constexpr int CellsPerSide = 4;

  /// A range in steps: value = smallest value of the volume + step * valuePerStep. A brick that
  /// holds a value that is not finite has smallest > largest.
  struct Steps
  {
    std::uint16_t smallest;
    std::uint16_t largest;

    bool IsFinite() const { return this->smallest <= this->largest; }
  };

  glm::ivec3 brickCount = glm::ivec3(0);
  std::vector<Steps> bricks; ///< x fastest
  double firstValue = 0.0;   ///< value of step 0
  double valuePerStep = 1.0;
};

/// Reads the volume once, on all cores.
/// @param smallestValue, largestValue  range of the finite values of the grid
template <class Scalar>
BrickRanges BuildBrickRanges(
  const ScalarGrid<Scalar>& grid, double smallestValue, double largestValue);

}

#endif
