#ifndef Varimarch_Core_Fields_CellField_h
#define Varimarch_Core_Fields_CellField_h

#include "Core/Geometry/ScalarGrid.h"

#include <cstdint>
#include <vector>

namespace varimarch
{

/// A field that says how far a ray may go before interpolated values change by more than a
/// tolerance: our variant of VariationField, with ranges of cells instead of differences of voxels.
///
/// It has one byte per cell, the unit cube between eight voxels: 0 if the cell itself varies by
/// more than the tolerance; otherwise k + 1 if the block of cells [c - k, c + k] on each axis,
/// clipped to the volume, does not. This block spans [c - k, c + k + 1] in grid space and reads the
/// voxels c - k ... c + k + 1.
///
/// The bound holds for *interpolated* values, not only for voxels: trilinear interpolation in a
/// cell stays within the range of its eight voxels, so any two positions in the block have values
/// that differ by at most the tolerance.
///
/// Documentation/Mathematics.md explains why it is per cell, and proves the bound.
struct CellField
{
  /// Largest stored k: blocks of 127 cells. Larger blocks would cost more to find than they save.
  static constexpr int LargestRadius = 63;

  glm::ivec3 cellCount = glm::ivec3(0);
  std::vector<std::uint8_t> cells; ///< x fastest
};

/// Builds the field of a grid on all cores. Each stored radius is the largest that keeps the bound,
/// up to LargestRadius. Cells that touch a voxel that is not finite exceed every tolerance. The
/// build needs two copies of the voxels with a margin: 2.6 times their memory for 512 voxels a
/// side, 3.2 times for 256.
/// @param tolerance  largest accepted difference of two values in a block, >= 0, in units of the
/// data
/// @throws std::invalid_argument if the tolerance is negative or NaN
template <class Scalar>
CellField BuildCellField(const ScalarGrid<Scalar>& grid, double tolerance);

}

#endif
