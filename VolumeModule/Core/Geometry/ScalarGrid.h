#ifndef Varimarch_Core_Geometry_ScalarGrid_h
#define Varimarch_Core_Geometry_ScalarGrid_h

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <cstddef>

namespace varimarch
{

/// A box of voxels within a grid.
struct VoxelRegion
{
  glm::ivec3 first;
  glm::ivec3 count; ///< number of voxels along each axis
};

/// A view of the scalar values on the points of a regular grid. It owns nothing; the voxels must
/// outlive it.
///
/// Positions are in *grid space*: voxel (i, j, k) is at (i, j, k), a cell is one unit wide, and the
/// volume fills [0, dimensions - 1]. Positions outside are clamped to the nearest face.
template <class Scalar>
class ScalarGrid
{
public:
  /// @param voxels  dimensions.x * dimensions.y * dimensions.z values, x fastest
  /// @param dimensions  number of voxels along each axis, each >= 1
  /// @param spacingMm  distance between neighbouring voxels along each axis [mm], > 0
  ScalarGrid(const Scalar* voxels, glm::ivec3 dimensions, glm::dvec3 spacingMm = glm::dvec3(1.0))
    : voxels(voxels)
    , dimensions(dimensions)
    , spacingMm(spacingMm)
    , valuesPerRow(dimensions.x)
    , valuesPerSlice(std::size_t(dimensions.x) * dimensions.y)
  {
  }

  /// A view of the voxels of a region.
  ScalarGrid Part(const VoxelRegion& region) const
  {
    ScalarGrid part = *this;
    part.voxels = this->Row(region.first.y, region.first.z) + region.first.x;
    part.dimensions = region.count;
    return part;
  }

  /// Pointer to voxel (0, y, z), followed by (1, y, z), ...
  const Scalar* Row(int y, int z) const
  {
    return this->voxels + z * this->valuesPerSlice + y * this->valuesPerRow;
  }

  glm::ivec3 Dimensions() const { return this->dimensions; }
  glm::dvec3 SpacingMm() const { return this->spacingMm; }

  /// Number of cells along each axis: one less than voxels but at least 1, so that a slab one voxel
  /// thick still has cells.
  glm::ivec3 CellCount() const { return glm::max(this->dimensions - 1, glm::ivec3(1)); }

  std::size_t VoxelCount() const
  {
    return std::size_t(this->dimensions.x) * this->dimensions.y * this->dimensions.z;
  }

  Scalar Voxel(glm::ivec3 index) const { return this->Row(index.y, index.z)[index.x]; }

  /// Value at a position in grid space, by trilinear interpolation.
  double Value(glm::dvec3 positionGrid) const
  {
    const glm::dvec3 last = glm::dvec3(this->dimensions - 1);
    const glm::dvec3 position = glm::clamp(positionGrid, glm::dvec3(0.0), last);
    const glm::ivec3 lower = glm::min(glm::ivec3(position), this->dimensions - 1);
    const glm::ivec3 upper = glm::min(lower + 1, this->dimensions - 1);
    const glm::dvec3 weight = position - glm::dvec3(lower);

    // Interpolates on four edges along x, then two along y, then one along z.
    const auto alongX = [&](int y, int z)
    {
      const double a = double(this->Voxel({ lower.x, y, z }));
      const double b = double(this->Voxel({ upper.x, y, z }));
      return a + (b - a) * weight.x;
    };
    const auto alongY = [&](int z)
    {
      const double a = alongX(lower.y, z);
      return a + (alongX(upper.y, z) - a) * weight.y;
    };
    const double a = alongY(lower.z);
    return a + (alongY(upper.z) - a) * weight.z;
  }

  /// Central difference of the values one voxel to either side, per mm along the grid's axes. At a
  /// face, clamping makes the outer value that of the face.
  glm::dvec3 Gradient(glm::dvec3 positionGrid) const
  {
    glm::dvec3 gradient;
    for (int axis = 0; axis < 3; ++axis)
    {
      glm::dvec3 offset(0.0);
      offset[axis] = 1.0;
      const double difference =
        this->Value(positionGrid + offset) - this->Value(positionGrid - offset);
      gradient[axis] = difference / (2.0 * this->spacingMm[axis]);
    }
    return gradient;
  }

private:
  const Scalar* voxels;
  glm::ivec3 dimensions;
  glm::dvec3 spacingMm;
  std::size_t valuesPerRow;
  std::size_t valuesPerSlice;
};

}

#endif
