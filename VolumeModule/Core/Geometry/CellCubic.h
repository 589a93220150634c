#ifndef Varimarch_Core_Geometry_CellCubic_h
#define Varimarch_Core_Geometry_CellCubic_h

#include "Core/Geometry/ScalarGrid.h"

#include <array>

namespace varimarch
{

/// The values at a cell's corners. Bit 0, 1 or 2 of the index is set for the far corner in x, y or
/// z.
using CellCorners = std::array<double, 8>;

/// The corners of the cell that spans [cell, cell + 1] in grid space. Cells outside the grid repeat
/// its outermost voxels, so that a grid one voxel thick is constant across its thickness.
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

/// Central differences per voxel along x, y and z at a cell's corners. Their trilinear
/// interpolation equals the difference of the interpolated values one voxel to either side, as in
/// ScalarGrid::Gradient.
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

/// Trilinear interpolation along a straight line through a cell: a cubic, stored as its four
/// Bernstein coefficients. They bound the values, and evaluation never leaves that range.
class CellCubic
{
public:
  /// @param enter, leave  positions in the cell, [0, 1] on each axis, at u = 0 and u = 1
  CellCubic(const CellCorners& corners, glm::dvec3 enter, glm::dvec3 leave);

  explicit CellCubic(const std::array<double, 4>& bernstein)
    : bernstein(bernstein)
  {
  }

  /// The same cubic, except that it starts with the end value of the piece before it, from which
  /// rounding may have separated it.
  CellCubic StartingAt(double value) const;

  /// @param u  position along the line, [0, 1]
  double Value(double u) const;

  const std::array<double, 4>& Bernstein() const { return this->bernstein; }

  /// Bounds of the values on [0, 1], which may not be attained.
  double LowerBound() const;
  double UpperBound() const;

  /// Ends of the monotone pieces of [0, 1]: 0, up to two extrema, and 1.
  struct Cuts
  {
    std::array<double, 4> u;
    int count;
  };
  Cuts MonotoneCuts() const;

  /// The parameter, accurate to rounding, at which the cubic takes a value.
  /// @param from, to  ends of a monotone piece; the value lies between the values there
  double Crossing(double value, double from, double to) const;

private:
  double Slope(double u) const;

  std::array<double, 4> bernstein;
};

}

#endif
