#ifndef Varimarch_Core_Geometry_UnevenAxis_h
#define Varimarch_Core_Geometry_UnevenAxis_h

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <vector>

namespace varimarch
{

/// One axis of a rectilinear grid. The volume's grid space stays even, from its first voxel to its
/// last, so that rays are straight in it. This class maps a position on the axis to a (fractional)
/// voxel.
class UnevenAxis
{
public:
  static constexpr int MostBins = 16384;

  /// @param points  coordinates, at least one
  /// @param ofCells  true if voxels are centred between points; the volume then extends from the
  /// first point to the last
  /// @param nearest  true if voxels have constant value, up to halfway to the next or to the cell's
  /// faces
  /// @throws std::invalid_argument if the points do not ascend, or are closer than MostBins allows
  UnevenAxis(const std::vector<double>& points, bool ofCells, bool nearest);

  int VoxelCount() const { return this->voxelCount; }
  double FirstVoxel() const { return this->firstVoxel; } ///< coordinate of position 0 in the grid
  double Step() const { return this->step; } ///< coordinate difference of one unit in the grid
  double LowerGrid() const { return this->lowerGrid; } ///< lower end of the volume
  double UpperGrid() const { return this->upperGrid; }
  double SmallestGapGrid() const { return this->smallestGapGrid; }

  /// The fractional voxel index at a position in the grid, clamped to the outermost voxels.
  double VoxelAt(double placeGrid) const;

  /// Bins of equal length from LowerGrid to UpperGrid. In each, the voxel index at a position g is
  /// y + (g - x) * (g < x ? z : w).
  std::vector<glm::vec4> Bins() const;

private:
  double PlaceGrid(double coordinate) const { return (coordinate - this->firstVoxel) / this->step; }

  int voxelCount;
  double firstVoxel;
  double step;
  double lowerGrid;
  double upperGrid;
  double smallestGapGrid;
  std::vector<double> breaks; ///< positions of voxel index firstBreakVoxel + i [grid]
  double firstBreakVoxel;
};

/// The bins of all axes of a grid, concatenated.
struct UnevenBins
{
  std::vector<glm::vec4> bins;      ///< see UnevenAxis::Bins; empty for even spacing
  glm::ivec3 first = glm::ivec3(0); ///< first bin of each axis
  glm::ivec3 last = glm::ivec3(0);
  glm::dvec3 lowerGrid = glm::dvec3(0.0); ///< where each axis's first bin begins
  glm::dvec3 binsPerGrid = glm::dvec3(0.0);
};

/// @param axes  three axes, or none
UnevenBins BinsOf(const std::vector<UnevenAxis>& axes);

}

#endif
