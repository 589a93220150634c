#ifndef Varimarch_Core_Fields_WindowRanges_h
#define Varimarch_Core_Fields_WindowRanges_h

#include "Core/Geometry/ScalarGrid.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <type_traits>

namespace varimarch
{

/// std::min and std::max by value; references to array elements would prevent vectorization.
struct Lower
{
  template <class Scalar>
  Scalar operator()(Scalar a, Scalar b) const
  {
    return b < a ? b : a;
  }
};

struct Higher
{
  template <class Scalar>
  Scalar operator()(Scalar a, Scalar b) const
  {
    return a < b ? b : a;
  }
};

/// Lowest and highest value of all windows: cubes of voxels of one size, addressed by their first
/// voxel. BuildCellField uses it. It copies the voxels, and can only double the window size.
///
/// Windows are clipped to the volume. They may start up to `Margin` voxels before the volume, so
/// that blocks clipped at a lower face are as tight as all others, and one voxel behind it. A
/// window outside the volume holds a range that changes no other when combined. `Overrun` more
/// windows can be read behind each row.
/// read behind any row.
template <class Scalar>
class WindowRanges
{
public:
  static constexpr int Overrun = 64;

  /// @param largestWindow  size up to which windows will be doubled
  WindowRanges(const ScalarGrid<Scalar>& grid, int largestWindow);

  void DoubleWindows();
  int WindowSize() const { return this->windowSize; }
  int Margin(int axis) const { return this->margin[axis]; }
  int VoxelCount(int axis) const { return this->extent[axis] - this->margin[axis] - 1; }

  /// Lowest()[Offset(x, y, z)] is the lowest value of the window that starts at voxel (x, y, z).
  std::ptrdiff_t Offset(int x, int y, int z) const
  {
    const std::ptrdiff_t row =
      std::ptrdiff_t(z + this->margin.z) * this->extent.y + y + this->margin.y;
    return row * this->extent.x + x + this->margin.x;
  }
  const Scalar* Lowest() const { return this->lowest.get(); }
  const Scalar* Highest() const { return this->highest.get(); }

private:
  using Limits = std::numeric_limits<Scalar>;
  static constexpr Scalar Above = Limits::has_infinity ? Limits::infinity() : Limits::max();
  static constexpr Scalar Below = Limits::has_infinity ? -Limits::infinity() : Limits::lowest();

  void CopyRow(const ScalarGrid<Scalar>& grid, int y, int z);
  void Merge(std::ptrdiff_t row, std::ptrdiff_t other, std::ptrdiff_t length);

  glm::ivec3 margin;
  glm::ivec3 extent;
  int windowSize = 1;
  std::unique_ptr<Scalar[]> lowest;
  std::unique_ptr<Scalar[]> highest;
};

template <class Scalar>
WindowRanges<Scalar>::WindowRanges(const ScalarGrid<Scalar>& grid, int largestWindow)
  // Along y and z, the earlier half of a window before the volume is not needed: the later one
  // covers it.
  : margin(glm::min(grid.Dimensions() - 1,
      glm::ivec3(largestWindow - 1, largestWindow / 2 - 1, largestWindow / 2 - 1)))
  , extent(grid.Dimensions() + this->margin + 1)
{
  const std::size_t count =
    std::size_t(this->extent.x) * std::size_t(this->extent.y) * std::size_t(this->extent.z);
  // Left uninitialized, so that the threads that fill the pages also touch them first.
  this->lowest.reset(new Scalar[count + Overrun]);
  this->highest.reset(new Scalar[count + Overrun]);
  std::fill_n(this->lowest.get() + count, Overrun, Above);
  std::fill_n(this->highest.get() + count, Overrun, Below);
  tbb::parallel_for(-this->margin.z, this->extent.z - this->margin.z,
    [&](int z)
    {
      for (int y = -this->margin.y; y < this->extent.y - this->margin.y; ++y)
      {
        this->CopyRow(grid, y, z);
      }
    });
}

template <class Scalar>
void WindowRanges<Scalar>::CopyRow(const ScalarGrid<Scalar>& grid, int y, int z)
{
  const std::ptrdiff_t row = this->Offset(0, y, z);
  Scalar* low = this->lowest.get() + row;
  Scalar* high = this->highest.get() + row;
  std::fill_n(low - this->margin.x, this->extent.x, Above);
  std::fill_n(high - this->margin.x, this->extent.x, Below);

  const glm::ivec3 dimensions = grid.Dimensions();
  if (y < 0 || y >= dimensions.y || z < 0 || z >= dimensions.z)
  {
    return;
  }
  const Scalar* const voxels = grid.Row(y, z);
  for (int x = 0; x < dimensions.x; ++x)
  {
    if constexpr (std::is_floating_point_v<Scalar>)
    {
      const bool finite = std::isfinite(voxels[x]);
      low[x] = finite ? voxels[x] : Below;
      high[x] = finite ? voxels[x] : Above;
    }
    else
    {
      low[x] = high[x] = voxels[x];
    }
  }
}

/// `other` is behind `row`, so that each value is read before it is overwritten in place.
template <class Scalar>
void WindowRanges<Scalar>::Merge(std::ptrdiff_t row, std::ptrdiff_t other, std::ptrdiff_t length)
{
  Scalar* low = this->lowest.get();
  Scalar* high = this->highest.get();
#pragma GCC ivdep
  for (std::ptrdiff_t i = 0; i < length; ++i)
  {
    low[row + i] = Lower()(low[row + i], low[other + i]);
  }
#pragma GCC ivdep
  for (std::ptrdiff_t i = 0; i < length; ++i)
  {
    high[row + i] = Higher()(high[row + i], high[other + i]);
  }
}

/// Merges two windows along each axis in turn, in place, into one of twice the size.
template <class Scalar>
void WindowRanges<Scalar>::DoubleWindows()
{
  const int half = this->windowSize;
  const std::ptrdiff_t rowLength = this->extent.x;
  const std::ptrdiff_t sliceLength = rowLength * this->extent.y;
  tbb::parallel_for(0, this->extent.z,
    [&](int z)
    {
      const std::ptrdiff_t slice = z * sliceLength;
      for (int y = 0; y < this->extent.y; ++y)
      {
        const std::ptrdiff_t row = slice + y * rowLength;
        this->Merge(row, row + half, rowLength - half);
      }
      for (int y = 0; y + half < this->extent.y; ++y)
      {
        const std::ptrdiff_t row = slice + y * rowLength;
        this->Merge(row, row + half * rowLength, rowLength);
      }
    });
  tbb::parallel_for(0, this->extent.y,
    [&](int y)
    {
      for (int z = 0; z + half < this->extent.z; ++z)
      {
        const std::ptrdiff_t row = z * sliceLength + y * rowLength;
        this->Merge(row, row + half * sliceLength, rowLength);
      }
    });
  this->windowSize *= 2;
}

}

#endif
