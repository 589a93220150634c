#ifndef Varimarch_Core_Geometry_CellCubic_h
#define Varimarch_Core_Geometry_CellCubic_h

#include "Core/Geometry/ScalarGrid.h"

#include <array>

namespace varimarch
{

/// The values at a cell's corners; bits 0, 1, 2 of the index say whether x, y, z is the far one.
using CellCorners = std::array<double, 8>;

/// The corners of the cell that spans [cell, cell + 1] in grid space. Cells beyond the grid repeat
/// its faces: a grid one voxel thick is constant across its thickness.
template <class Scalar>
CellCorners CornersOfCell(const ScalarGrid<Scalar>& grid, glm::ivec3 cell)
{
  const glm::ivec3 last = grid.Dimensions() - 1;
  const glm::ivec3 lower = glm::clamp(cell, glm::ivec3(0), last);
  const glm::ivec3 upper = glm::clamp(cell + 1, glm::ivec3(0), last);
  CellCorners corners;
  for (int i = 0; i < 8; ++i)
  {
    corners[i] = double(grid.Voxel(
      { (i & 1 ? upper : lower).x, (i & 2 ? upper : lower).y, (i & 4 ? upper : lower).z }));
  }
  return corners;
}

/// Central differences per voxel along x, y and z at a cell's corners. Trilinear interpolation of
/// these is the difference of the interpolated values one voxel to either side, as
/// ScalarGrid::Gradient has it.
template <class Scalar>
std::array<CellCorners, 3> GradientsOfCell(const ScalarGrid<Scalar>& grid, glm::ivec3 cell)
{
  std::array<CellCorners, 3> gradients;
  for (int axis = 0; axis < 3; ++axis)
  {
    glm::ivec3 offset(0);
    offset[axis] = 1;
    const CellCorners after = CornersOfCell(grid, cell + offset);
    const CellCorners before = CornersOfCell(grid, cell - offset);
    for (int i = 0; i < 8; ++i)
    {
      gradients[axis][i] = 0.5 * (after[i] - before[i]);
    }
  }
  return gradients;
}

/// Trilinear interpolation along a straight line through a cell: exactly a cubic, kept by its four
/// Bernstein coefficients. They enclose the values, and evaluation never leaves their range.
class CellCubic
{
public:
  /// @param enter, leave  positions in the cell, [0, 1] on each axis, where u is 0 and 1
  CellCubic(const CellCorners& corners, glm::dvec3 enter, glm::dvec3 leave);

  explicit CellCubic(const std::array<double, 4>& bernstein)
    : bernstein(bernstein)
  {
  }

  /// The same but for its value at 0: that of the piece before it, where round-off made two.
  CellCubic StartingAt(double value) const;

  /// @param u  position along the line, [0, 1]
  double Value(double u) const;

  const std::array<double, 4>& Bernstein() const { return this->bernstein; }

  /// Bounds of the values on [0, 1], not always attained.
  double LowerBound() const;
  double UpperBound() const;

  /// Where monotone pieces of [0, 1] begin and end: 0, up to two extremes, 1.
  struct Cuts
  {
    std::array<double, 4> u;
    int count;
  };
  Cuts MonotoneCuts() const;

  /// Where a piece [from, to] on which the cubic is monotone takes a value that lies between those
  /// at its ends, to the last bit that round-off leaves.
  double Crossing(double value, double from, double to) const;

private:
  double Slope(double u) const;

  std::array<double, 4> bernstein;
};

}

#endif
