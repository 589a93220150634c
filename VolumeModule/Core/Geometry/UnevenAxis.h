#ifndef Varimarch_Core_Geometry_UnevenAxis_h
#define Varimarch_Core_Geometry_UnevenAxis_h

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <vector>

namespace varimarch
{

/// One axis of a rectilinear grid. The volume's grid stays even, from its first voxel to its last,
/// so that rays are straight in it; this says which voxel, or what between two, is where.
class UnevenAxis
{
public:
  static constexpr int MostBins = 16384;

  /// @param points   coordinates, at least one
  /// @param ofCells  whether voxels are in the middle between points; what is drawn then reaches
  ///                 from the first point to the last
  /// @param nearest  whether a voxel's value holds as far as it is the nearest, or its cell goes
  /// @throws std::invalid_argument where they do not ascend, or lie closer than MostBins allows
  UnevenAxis(const std::vector<double>& points, bool ofCells, bool nearest);

  int VoxelCount() const { return this->voxelCount; }
  double FirstVoxel() const { return this->firstVoxel; } ///< coordinate of 0 in the grid
  double Step() const { return this->step; }             ///< and from there to 1
  double LowerGrid() const { return this->lowerGrid; }   ///< what is drawn
  double UpperGrid() const { return this->upperGrid; }
  double SmallestGapGrid() const { return this->smallestGapGrid; }

  /// The voxel, or what is between two, at a place of the grid; beyond the outermost ones these.
  double VoxelAt(double placeGrid) const;

  /// Bins of equal length from LowerGrid to UpperGrid. In each, the voxel at a place g is
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
  std::vector<double> breaks; ///< where the voxel is firstBreakVoxel + index [grid]
  double firstBreakVoxel;
};

/// The bins of all axes of a grid, one behind the other.
struct UnevenBins
{
  std::vector<glm::vec4> bins;      ///< see UnevenAxis::Bins; none: places are even
  glm::ivec3 first = glm::ivec3(0); ///< of each axis
  glm::ivec3 last = glm::ivec3(0);
  glm::dvec3 lowerGrid = glm::dvec3(0.0); ///< where the first begins
  glm::dvec3 binsPerGrid = glm::dvec3(0.0);
};

/// @param axes  three, or none
UnevenBins BinsOf(const std::vector<UnevenAxis>& axes);

}

#endif
