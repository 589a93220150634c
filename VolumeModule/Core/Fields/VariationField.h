#ifndef Varimarch_Core_Fields_VariationField_h
#define Varimarch_Core_Fields_VariationField_h

#include "Core/Geometry/ScalarGrid.h"

#include <cstdint>
#include <vector>

namespace varimarch
{

/// How far a ray may go before the volume changes by more than a tolerance.
///
/// One byte per cell (the unit cube between eight voxels): 0 where the cell itself varies by more
/// than the tolerance, else k + 1 where the block of cells [c - k, c + k] on each axis, cut at the
/// faces of the volume, varies by no more than it. Block [c - k, c + k] of cells spans
/// [c - k, c + k + 1] in grid space and reads the voxels c - k ... c + k + 1.
///
/// The promise holds for *interpolated* values, not for voxels alone: trilinear interpolation in a
/// cell never leaves the range of the cell's eight voxels, so any two positions in the block have
/// values that differ by at most the tolerance.
///
/// After Banquero, Ortiz and Rossi, "Realtime volume render en videojuegos" (2016), whose field
/// is a distance per voxel; Documentation/Mathematics.md says why cells, and proves the promise.
struct VariationField
{
  /// Largest k stored: blocks of 127 cells. Larger ones would cost more to find than they save.
  static constexpr int LargestRadius = 63;

  glm::ivec3 cellCount = glm::ivec3(0);
  std::vector<std::uint8_t> cells; ///< x fastest
};

/// Builds the field of a grid on all cores.
/// @param tolerance  largest accepted difference of two values in a block, >= 0, units of the data
/// A voxel that is not finite makes the cells that touch it vary without bound, whatever the
/// tolerance. Every stored radius is the largest that keeps the promise, up to LargestRadius.
/// While it runs it takes two copies of the voxels with a margin: 2.6 times their memory at 512
/// voxels a side, 3.2 times at 256.
/// @throws std::invalid_argument for a tolerance that is negative or not a number
template <class Scalar>
VariationField BuildVariationField(const ScalarGrid<Scalar>& grid, double tolerance);

}

#endif
