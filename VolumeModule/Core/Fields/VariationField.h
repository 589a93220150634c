#ifndef Varimarch_Core_Fields_VariationField_h
#define Varimarch_Core_Fields_VariationField_h

#include "Core/Geometry/ScalarGrid.h"

#include <cstdint>
#include <vector>

namespace varimarch
{

/// The distance between two voxels, in voxels.
enum class VoxelDistance
{
  Euclidean, ///< voxels closer than d lie in a ball
  Chebyshev, ///< voxels closer than d lie in a cube: the largest difference of an index
};

/// The field of variations S of Banquero, Ortiz and Rossi, "Realtime volume render en videojuegos"
/// (2016), equation 3: S(p) is the largest distance d for which every voxel q with |p - q| < d
/// has a value with |I(p) - I(q)| < E.
///
/// A voxel that is not finite, or has such a neighbour, has no smaller distance to a different
/// value than to that voxel. The promise is about voxels: interpolated values inside the ball may
/// differ by more than E, because they also depend on voxels outside it. CellField keeps its
/// promise for these.
struct VariationField
{
  /// Largest stored distance [voxels], also that of a voxel that differs from no other.
  static constexpr int Farthest = 255;

  glm::ivec3 voxelCount = glm::ivec3(0);
  std::vector<std::uint8_t> voxels; ///< whole distances from 1 to Farthest, x fastest
};

/// Builds the field of a grid on all cores. Beside the field, this takes two sevenths of the memory
/// of the voxels.
/// @param tolerance  E in units of the data, >= 0
/// @throws std::invalid_argument if the tolerance is negative or NaN
template <class Scalar>
VariationField BuildVariationField(
  const ScalarGrid<Scalar>& grid, double tolerance, VoxelDistance distance);

}

#endif
