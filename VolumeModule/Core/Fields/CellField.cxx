#include "Core/Fields/CellField.h"

#include "Core/Geometry/ScalarGrid.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

namespace varimarch
{
namespace
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

/// Tests without overflow whether two values differ by at most a tolerance. Integers are compared
/// in the unsigned type of their width, in which the difference is exact.
template <class Scalar, bool = std::is_integral_v<Scalar>>
class WithinTolerance
{
public:
  explicit WithinTolerance(double tolerance)
    : tolerance(tolerance >= double(std::numeric_limits<Magnitude>::max())
          ? std::numeric_limits<Magnitude>::max()
          : Magnitude(tolerance))
  {
  }

  bool operator()(Scalar lowest, Scalar highest) const
  {
    return Magnitude(Magnitude(highest) - Magnitude(lowest)) <= this->tolerance;
  }

private:
  using Magnitude = std::make_unsigned_t<Scalar>;
  Magnitude tolerance;
};

template <class Scalar>
class WithinTolerance<Scalar, false>
{
public:
  // The tolerance stays finite, so that the infinite range of a cell with a NaN never passes.
  explicit WithinTolerance(double tolerance)
    : tolerance(std::min(tolerance, std::numeric_limits<double>::max()))
  {
  }

  bool operator()(Scalar lowest, Scalar highest) const
  {
    return double(highest) - double(lowest) <= this->tolerance;
  }

private:
  double tolerance;
};

/// The eight windows that cover the block of each cell of a row: two along x in each of four rows.
template <class Scalar>
struct Windows
{
  Windows(const Scalar* ranges, const std::ptrdiff_t (&rows)[4], int step)
    : rows{ ranges + rows[0], ranges + rows[1], ranges + rows[2], ranges + rows[3] }
    , step(step)
  {
  }

  template <class Combine>
  Scalar Combined(int cell, Combine combine) const
  {
    const auto row = [&](int i)
    { return combine(this->rows[i][cell], this->rows[i][cell + this->step]); };
    return combine(combine(row(0), row(1)), combine(row(2), row(3)));
  }

  const Scalar* rows[4];
  int step;
};

/// Fills a field, block size by block size. The *size* of a cell is the stored number: radius + 1,
/// or 0.
///
/// A block of size s reads 2 s voxels along each axis; two windows of size w, w / 2 <= s <= w,
/// cover it. A block that fits contains all smaller blocks of its cell, so a cell's size is the
/// number of block sizes that fit.
template <class Scalar>
class FieldBuilder
{
public:
  FieldBuilder(const ScalarGrid<Scalar>& grid, double tolerance);
  CellField Build();

private:
  /// Number of cells that are tested together, so that the compiler vectorizes the loop.
  static constexpr int ChunkLength = WindowRanges<Scalar>::Overrun;
  using Chunk = std::array<std::uint8_t, ChunkLength>;

  /// First voxels of the two windows that cover a block along one axis.
  struct Starts
  {
    int first;
    int second;
  };

  bool FillLevel();
  bool FillSlice(int z, bool sliceBelowIsDone);
  bool FillChunk(glm::ivec3 cell, int knownSize);
  int SmallestSizeBeside(glm::ivec3 cell, bool sliceBelowIsDone) const;
  bool AddFitting(glm::ivec3 cell, int size, Chunk& sizes) const;
  Starts WindowStarts(int axis, int cell, int size) const;

  int CellsInChunk(int x) const { return std::min(ChunkLength, this->field.cellCount.x - x); }
  const std::uint8_t* Sizes(glm::ivec3 cell) const
  {
    const glm::ivec3 count = this->field.cellCount;
    return &this->field.cells[(std::size_t(cell.z) * count.y + cell.y) * count.x + cell.x];
  }
  std::uint8_t* Sizes(glm::ivec3 cell)
  {
    return const_cast<std::uint8_t*>(std::as_const(*this).Sizes(cell));
  }

  CellField field;
  WindowRanges<Scalar> ranges;
  WithinTolerance<Scalar> within;
};

template <class Scalar>
FieldBuilder<Scalar>::FieldBuilder(const ScalarGrid<Scalar>& grid, double tolerance)
  : ranges(grid, CellField::LargestRadius + 1)
  , within(tolerance)
{
  const glm::ivec3 count = grid.CellCount();
  this->field.cellCount = count;
  this->field.cells.resize(std::size_t(count.x) * std::size_t(count.y) * std::size_t(count.z));
}

template <class Scalar>
CellField FieldBuilder<Scalar>::Build()
{
  bool anyFitsAll = this->FillLevel();
  while (anyFitsAll && this->ranges.WindowSize() <= CellField::LargestRadius)
  {
    this->ranges.DoubleWindows();
    anyFitsAll = this->FillLevel();
  }
  return std::move(this->field);
}

/// Tests all block sizes that the present windows serve.
/// @return true if any cell fits the largest of them
template <class Scalar>
bool FieldBuilder<Scalar>::FillLevel()
{
  std::atomic<bool> anyFitsAll = false;
  tbb::parallel_for(tbb::blocked_range<int>(0, this->field.cellCount.z),
    [&](const tbb::blocked_range<int>& slices)
    {
      for (int z = slices.begin(); z < slices.end(); ++z)
      {
        if (this->FillSlice(z, z > slices.begin()))
        {
          anyFitsAll = true;
        }
      }
    });
  return anyFitsAll;
}

template <class Scalar>
bool FieldBuilder<Scalar>::FillSlice(int z, bool sliceBelowIsDone)
{
  bool anyFitsAll = false;
  for (int y = 0; y < this->field.cellCount.y; ++y)
  {
    for (int x = 0; x < this->field.cellCount.x; x += ChunkLength)
    {
      const int knownSize = this->SmallestSizeBeside({ x, y, z }, sliceBelowIsDone) - 1;
      anyFitsAll |= this->FillChunk({ x, y, z }, knownSize);
    }
  }
  return anyFitsAll;
}

/// The smallest size among the preceding cells along y or z, if those are done. A cell's block
/// contains the next smaller block of each neighbour, so sizes of neighbours differ by at most one,
/// and what the neighbours prove need not be tested.
template <class Scalar>
int FieldBuilder<Scalar>::SmallestSizeBeside(glm::ivec3 cell, bool sliceBelowIsDone) const
{
  const auto smallest = [&](glm::ivec3 start)
  {
    const std::uint8_t* sizes = this->Sizes(start);
    return int(*std::min_element(sizes, sizes + this->CellsInChunk(start.x)));
  };
  const int alongY = cell.y > 0 ? smallest(cell - glm::ivec3(0, 1, 0)) : 0;
  const int alongZ = sliceBelowIsDone ? smallest(cell - glm::ivec3(0, 0, 1)) : 0;
  return std::max(alongY, alongZ);
}

/// @param knownSize  a size that fits all cells of the chunk
template <class Scalar>
bool FieldBuilder<Scalar>::FillChunk(glm::ivec3 cell, int knownSize)
{
  std::uint8_t* stored = this->Sizes(cell);
  const int length = this->CellsInChunk(cell.x);
  const int windowSize = this->ranges.WindowSize();
  const int smallest = std::max(windowSize / 2, knownSize);
  if (std::all_of(stored, stored + length, [&](int size) { return size < windowSize / 2; }))
  {
    return false;
  }

  Chunk sizes{};
  bool anyFits = true;
  for (int size = smallest + 1; size <= windowSize && anyFits; ++size)
  {
    anyFits = this->AddFitting(cell, size, sizes);
  }
  bool anyFitsAll = false;
  for (int i = 0; i < length; ++i)
  {
    const int size = std::max<int>(stored[i], knownSize) + sizes[i];
    stored[i] = std::uint8_t(size);
    anyFitsAll |= size == windowSize;
  }
  return anyFitsAll;
}

/// Adds one to each cell of the chunk whose block of this size fits.
/// @return true if any fits
template <class Scalar>
bool FieldBuilder<Scalar>::AddFitting(glm::ivec3 cell, int size, Chunk& sizes) const
{
  const Starts x = this->WindowStarts(0, cell.x, size);
  const Starts y = this->WindowStarts(1, cell.y, size);
  const Starts z = this->WindowStarts(2, cell.z, size);
  const std::ptrdiff_t rows[4] = { this->ranges.Offset(x.first, y.first, z.first),
    this->ranges.Offset(x.first, y.second, z.first),
    this->ranges.Offset(x.first, y.first, z.second),
    this->ranges.Offset(x.first, y.second, z.second) };
  const Windows<Scalar> lowest(this->ranges.Lowest(), rows, x.second - x.first);
  const Windows<Scalar> highest(this->ranges.Highest(), rows, x.second - x.first);

  const int length = this->CellsInChunk(cell.x);
  const WithinTolerance<Scalar> fits = this->within;
  std::uint8_t any = 0;
#pragma GCC ivdep
  for (int i = 0; i < ChunkLength; ++i)
  {
    const std::uint8_t one = fits(lowest.Combined(i, Lower()), highest.Combined(i, Higher()));
    sizes[i] += one;
    any |= one & (i < length);
  }
  return any != 0;
}

/// A block as long as the volume covers it from every cell, so larger ones are the same.
template <class Scalar>
typename FieldBuilder<Scalar>::Starts FieldBuilder<Scalar>::WindowStarts(
  int axis, int cell, int size) const
{
  const int cutSize = std::min(size, this->ranges.VoxelCount(axis));
  const int first = std::max(cell - cutSize + 1, -this->ranges.Margin(axis));
  const int last = cell + cutSize - this->ranges.WindowSize() + 1;
  return { first, std::max(first, last) };
}

}

template <class Scalar>
CellField BuildCellField(const ScalarGrid<Scalar>& grid, double tolerance)
{
  if (!(tolerance >= 0.0))
  {
    throw std::invalid_argument(
      "Cannot build a cell field: expected a tolerance of at least 0, found " +
      std::to_string(tolerance));
  }
  return FieldBuilder<Scalar>(grid, tolerance).Build();
}

#define VARIMARCH_FIELD_OF(Scalar) \
  template CellField BuildCellField(const ScalarGrid<Scalar>&, double)
VARIMARCH_FIELD_OF(char);

VARIMARCH_FIELD_OF(signed char);

VARIMARCH_FIELD_OF(unsigned char);

VARIMARCH_FIELD_OF(short);

VARIMARCH_FIELD_OF(unsigned short);

VARIMARCH_FIELD_OF(int);

VARIMARCH_FIELD_OF(unsigned int);

VARIMARCH_FIELD_OF(long);

VARIMARCH_FIELD_OF(unsigned long);

VARIMARCH_FIELD_OF(long long);

VARIMARCH_FIELD_OF(unsigned long long);

VARIMARCH_FIELD_OF(float);

VARIMARCH_FIELD_OF(double);

#undef VARIMARCH_FIELD_OF

}
