#include "Core/VariationField.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace varimarch
{

namespace
{

/// Whether the difference of two values stays within a tolerance, decided without overflow.
/// Integers compare in the unsigned type of their own width, in which the difference is exact.
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
  // Finite at most, so that the infinite range of a cell with a NaN never passes.
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

/// Lowest and highest value of every window of 2^level voxels a side, named by its first voxel.
///
/// A window is cut at the volume's faces. It may start up to `Margin` voxels before the volume,
/// so that blocks cut at the lower faces are as tight as all others, and one voxel behind it;
/// where a window misses the volume it holds a range that changes no other.
/// Doubling a window is min(W(v), W(v + half)) along each axis in turn, in place.
template <class Scalar>
class WindowRanges
{
public:
  explicit WindowRanges(const ScalarGrid<Scalar>& grid);

  void DoubleWindows();
  int WindowSize() const { return this->windowSize; }
  int Margin(int axis) const { return this->margin[axis]; }

  /// Where the windows lie that start at voxel (0, y, z).
  std::ptrdiff_t RowOffset(int y, int z) const
  {
    return (std::ptrdiff_t(z + this->margin.z) * this->extent.y + y + this->margin.y) *
      this->extent.x +
      this->margin.x;
  }
  const Scalar* Lowest() const { return this->lowest.get(); }
  const Scalar* Highest() const { return this->highest.get(); }

private:
  void CopyRow(const ScalarGrid<Scalar>& grid, int y, int z);
  void Merge(std::ptrdiff_t row, std::ptrdiff_t other, std::ptrdiff_t length);

  glm::ivec3 margin;
  glm::ivec3 extent;
  int windowSize = 1;
  std::unique_ptr<Scalar[]> lowest;
  std::unique_ptr<Scalar[]> highest;
};

/// Half of the largest window, less one: no block needs a window that starts earlier.
constexpr int LargestMargin = (VariationField::LargestRadius + 2) / 2 - 1;

template <class Scalar>
WindowRanges<Scalar>::WindowRanges(const ScalarGrid<Scalar>& grid)
  : margin(glm::min(grid.Dimensions(), LargestMargin))
  , extent(grid.Dimensions() + this->margin + 1)
{
  const std::size_t count =
    std::size_t(this->extent.x) * std::size_t(this->extent.y) * std::size_t(this->extent.z);
  // Left uninitialised: the threads that fill the pages also touch them first.
  this->lowest.reset(new Scalar[count]);
  this->highest.reset(new Scalar[count]);
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
  using Limits = std::numeric_limits<Scalar>;
  constexpr Scalar largest = Limits::has_infinity ? Limits::infinity() : Limits::max();
  constexpr Scalar smallest = Limits::has_infinity ? -Limits::infinity() : Limits::lowest();
  const std::ptrdiff_t row = this->RowOffset(y, z);
  Scalar* low = this->lowest.get() + row;
  Scalar* high = this->highest.get() + row;
  std::fill_n(low - this->margin.x, this->extent.x, largest);
  std::fill_n(high - this->margin.x, this->extent.x, smallest);

  const glm::ivec3 dimensions = grid.Dimensions();
  if (y < 0 || y >= dimensions.y || z < 0 || z >= dimensions.z)
  {
    return;
  }
  const Scalar* voxels =
    grid.Voxels() + (std::size_t(z) * dimensions.y + y) * std::size_t(dimensions.x);
  for (int x = 0; x < dimensions.x; ++x)
  {
    if constexpr (std::is_floating_point_v<Scalar>)
    {
      const bool finite = std::isfinite(voxels[x]);
      low[x] = finite ? voxels[x] : smallest;
      high[x] = finite ? voxels[x] : largest;
    }
    else
    {
      low[x] = high[x] = voxels[x];
    }
  }
}

/// `other` lies behind `row`, so that in place a value is read before it is overwritten.
template <class Scalar>
void WindowRanges<Scalar>::Merge(std::ptrdiff_t row, std::ptrdiff_t other, std::ptrdiff_t length)
{
  Scalar* low = this->lowest.get();
  Scalar* high = this->highest.get();
#pragma GCC ivdep
  for (std::ptrdiff_t i = 0; i < length; ++i)
  {
    low[row + i] = std::min(low[row + i], low[other + i]);
  }
#pragma GCC ivdep
  for (std::ptrdiff_t i = 0; i < length; ++i)
  {
    high[row + i] = std::max(high[row + i], high[other + i]);
  }
}

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

/// Fills a field size by size. The *size* of a cell is what the field stores: radius + 1, or 0.
/// A block of size s reads 2 s voxels a side, at most two windows of the level's size w wherever
/// w / 2 <= s <= w. A cell that fits size w stays active for the next level.
template <class Scalar>
class FieldBuilder
{
public:
  FieldBuilder(const ScalarGrid<Scalar>& grid, double tolerance)
    : ranges(grid)
    , within(tolerance)
  {
    this->field.cellCount = grid.CellCount();
    const glm::ivec3 count = this->field.cellCount;
    this->field.cells.resize(std::size_t(count.x) * std::size_t(count.y) * std::size_t(count.z));
  }

  VariationField Build()
  {
    bool active = this->FillLevel();
    while (active && this->ranges.WindowSize() <= VariationField::LargestRadius)
    {
      this->ranges.DoubleWindows();
      active = this->FillLevel();
    }
    return std::move(this->field);
  }

private:
  /// The four rows of windows, as offsets, that cover the blocks of a row of cells along y and z.
  struct Cover
  {
    std::ptrdiff_t rows[4];
  };

  bool FillLevel();
  bool FillRow(int y, int z, std::vector<std::uint8_t>& fits);
  Cover BlockCover(int size, int y, int z) const;
  void TestRow(int y, int z, std::uint8_t* fits) const;
  bool Fits(int size, int x, int y, int z) const;
  int LargestFittingSize(int x, int y, int z) const;

  int LargestSize() const
  {
    return std::min(this->ranges.WindowSize(), VariationField::LargestRadius + 1);
  }
  int FirstStart(int axis, int size, int cell) const
  {
    return std::max(cell - size + 1, -this->ranges.Margin(axis));
  }
  int SecondStart(int axis, int size, int cell) const
  {
    return std::max(cell + size - this->ranges.WindowSize() + 1, -this->ranges.Margin(axis));
  }
  /// Where the sizes of a row of cells start in the field.
  std::size_t Row(int y, int z) const
  {
    return (std::size_t(z) * this->field.cellCount.y + y) * this->field.cellCount.x;
  }

  VariationField field;
  WindowRanges<Scalar> ranges;
  WithinTolerance<Scalar> within;
};

template <class Scalar>
typename FieldBuilder<Scalar>::Cover FieldBuilder<Scalar>::BlockCover(int size, int y, int z) const
{
  const int firstY = this->FirstStart(1, size, y);
  const int firstZ = this->FirstStart(2, size, z);
  const int secondY = this->SecondStart(1, size, y);
  const int secondZ = this->SecondStart(2, size, z);
  return { { this->ranges.RowOffset(firstY, firstZ), this->ranges.RowOffset(secondY, firstZ),
    this->ranges.RowOffset(firstY, secondZ), this->ranges.RowOffset(secondY, secondZ) } };
}

template <class Scalar>
bool FieldBuilder<Scalar>::Fits(int size, int x, int y, int z) const
{
  const Cover cover = this->BlockCover(size, y, z);
  const int starts[2] = { this->FirstStart(0, size, x), this->SecondStart(0, size, x) };
  Scalar low = this->ranges.Lowest()[cover.rows[0] + starts[0]];
  Scalar high = this->ranges.Highest()[cover.rows[0] + starts[0]];
  for (const std::ptrdiff_t row : cover.rows)
  {
    for (const int start : starts)
    {
      low = std::min(low, this->ranges.Lowest()[row + start]);
      high = std::max(high, this->ranges.Highest()[row + start]);
    }
  }
  return this->within(low, high);
}

/// Tests the level's largest size for a whole row of cells; written to vectorise.
template <class Scalar>
void FieldBuilder<Scalar>::TestRow(int y, int z, std::uint8_t* fits) const
{
  const int size = this->LargestSize();
  const int cellCount = this->field.cellCount.x;
  // Here the first window would start before the margin.
  const int irregular = std::clamp(size - 1 - this->ranges.Margin(0), 0, cellCount);
  for (int x = 0; x < irregular; ++x)
  {
    fits[x] = this->Fits(size, x, y, z);
  }

  const Cover cover = this->BlockCover(size, y, z);
  const int first = 1 - size;
  const int second = size - this->ranges.WindowSize() + 1;
  const Scalar* lowest = this->ranges.Lowest();
  const Scalar* highest = this->ranges.Highest();
  const Scalar* low[4];
  const Scalar* high[4];
  for (int i = 0; i < 4; ++i)
  {
    low[i] = lowest + cover.rows[i];
    high[i] = highest + cover.rows[i];
  }
#pragma GCC ivdep
  for (int x = irregular; x < cellCount; ++x)
  {
    const int a = x + first;
    const int b = x + second;
    const Scalar lowestOfBlock =
      std::min(std::min(std::min(low[0][a], low[0][b]), std::min(low[1][a], low[1][b])),
        std::min(std::min(low[2][a], low[2][b]), std::min(low[3][a], low[3][b])));
    const Scalar highestOfBlock =
      std::max(std::max(std::max(high[0][a], high[0][b]), std::max(high[1][a], high[1][b])),
        std::max(std::max(high[2][a], high[2][b]), std::max(high[3][a], high[3][b])));
    fits[x] = this->within(lowestOfBlock, highestOfBlock);
  }
}

/// The size of a cell that fits half a window but not the level's largest size. The block of a
/// neighbour, one smaller, lies inside this block and the other way round: sizes of neighbours
/// differ by at most one, so that mostly nothing is left to test.
template <class Scalar>
int FieldBuilder<Scalar>::LargestFittingSize(int x, int y, int z) const
{
  int smallest = this->ranges.WindowSize() / 2;
  int largest = this->LargestSize() - 1;
  const auto neighbour = [&](int size)
  {
    smallest = std::max(smallest, size - 1);
    largest = std::min(largest, size + 1);
  };
  if (x > 0)
  {
    neighbour(this->field.cells[this->Row(y, z) + x - 1]);
  }
  if (y > 0)
  {
    neighbour(this->field.cells[this->Row(y - 1, z) + x]);
  }
  while (smallest < largest)
  {
    const int middle = (smallest + largest + 1) / 2;
    if (this->Fits(middle, x, y, z))
    {
      smallest = middle;
    }
    else
    {
      largest = middle - 1;
    }
  }
  return smallest;
}

/// Decides the active cells of a row. @return whether any stays active
template <class Scalar>
bool FieldBuilder<Scalar>::FillRow(int y, int z, std::vector<std::uint8_t>& fits)
{
  std::uint8_t* sizes = this->field.cells.data() + this->Row(y, z);
  const int cellCount = this->field.cellCount.x;
  const std::uint8_t active = this->ranges.WindowSize() / 2;
  if (std::find(sizes, sizes + cellCount, active) == sizes + cellCount)
  {
    return false;
  }
  this->TestRow(y, z, fits.data());
  bool anyActive = false;
  for (int x = 0; x < cellCount; ++x)
  {
    if (sizes[x] == active)
    {
      sizes[x] = fits[x] ? this->LargestSize() : this->LargestFittingSize(x, y, z);
      anyActive |= fits[x] != 0;
    }
  }
  return anyActive;
}

/// Decides all active cells at the present window size. @return whether any stays active
template <class Scalar>
bool FieldBuilder<Scalar>::FillLevel()
{
  std::atomic<bool> anyActive = false;
  tbb::parallel_for(tbb::blocked_range<int>(0, this->field.cellCount.z),
    [&](const tbb::blocked_range<int>& slices)
    {
      std::vector<std::uint8_t> fits(this->field.cellCount.x);
      for (int z = slices.begin(); z < slices.end(); ++z)
      {
        for (int y = 0; y < this->field.cellCount.y; ++y)
        {
          if (this->FillRow(y, z, fits))
          {
            anyActive = true;
          }
        }
      }
    });
  return anyActive;
}

}

template <class Scalar>
VariationField BuildVariationField(const ScalarGrid<Scalar>& grid, double tolerance)
{
  if (!(tolerance >= 0.0))
  {
    throw std::invalid_argument(
      "Variation field: the tolerance must be 0 or more, found " + std::to_string(tolerance));
  }
  return FieldBuilder<Scalar>(grid, tolerance).Build();
}

#define VARIMARCH_FIELD_OF(Scalar) \
  template VariationField BuildVariationField(const ScalarGrid<Scalar>&, double)
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
