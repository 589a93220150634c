#include "Core/Fields/BrickRanges.h"

#include "Core/Look/ValueRange.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <limits>

namespace varimarch
{
namespace
{

constexpr double LargestStep = 65535.0;

// Widens ranges by the values of columns that lie side by side. A compiler takes them together if
// their number is a constant.
template <class Scalar, int Columns>
void Widen(Scalar* __restrict smallest, Scalar* __restrict largest, const Scalar* __restrict values)
{
  for (int x = 0; x < Columns; ++x)
  {
    const Scalar value = values[x];
    smallest[x] = value < smallest[x] ? value : smallest[x];
    largest[x] = largest[x] < value ? value : largest[x];
  }
}

// Smallest and largest value of each column of voxels in a bundle of rows.
template <class Scalar>
struct ColumnRanges
{
  explicit ColumnRanges(int width)
    : smallest(width)
    , largest(width)
    , finite(width)
  {
  }

  void Start()
  {
    std::fill(this->smallest.begin(), this->smallest.end(), std::numeric_limits<Scalar>::max());
    std::fill(this->largest.begin(), this->largest.end(), std::numeric_limits<Scalar>::lowest());
    std::fill(this->finite.begin(), this->finite.end(), std::uint8_t(1));
  }

  void Add(const Scalar* row)
  {
    const std::size_t width = this->smallest.size();
    constexpr int Together = 32;
    std::size_t first = 0;
    for (; first + Together <= width; first += Together)
    {
      Widen<Scalar, Together>(&this->smallest[first], &this->largest[first], row + first);
    }
    for (; first < width; ++first)
    {
      Widen<Scalar, 1>(&this->smallest[first], &this->largest[first], row + first);
    }
    if constexpr (!std::numeric_limits<Scalar>::is_integer)
    {
      for (std::size_t x = 0; x < width; ++x)
      {
        this->finite[x] &= std::uint8_t(std::isfinite(row[x]));
      }
    }
  }

  std::vector<Scalar> smallest;
  std::vector<Scalar> largest;
  std::vector<std::uint8_t> finite;
};

// The range of columns first ... last in steps, rounded outwards.
template <class Scalar>
BrickRanges::Steps StepsOf(
  const ColumnRanges<Scalar>& columns, int first, int last, const BrickRanges& ranges)
{
  Scalar smallest = columns.smallest[first];
  Scalar largest = columns.largest[first];
  bool finite = true;
  for (int x = first; x <= last; ++x)
  {
    smallest = std::min(smallest, columns.smallest[x]);
    largest = std::max(largest, columns.largest[x]);
    finite = finite && columns.finite[x];
  }
  if (!finite)
  {
    return { 1, 0 };
  }
  const auto steps = [&](Scalar value)
  { return (double(value) - ranges.FirstValue()) / ranges.ValuePerStep(); };
  const double lastStep = ranges.LastStep();
  return { std::uint16_t(std::clamp(std::floor(steps(smallest)), 0.0, lastStep)),
    std::uint16_t(std::clamp(std::ceil(steps(largest)), 0.0, lastStep)) };
}

// One step is exactly 1 for integers that span less than 2^16.
double ValuePerStep(double range, bool integers)
{
  if (!(range > SmallestDifference))
  {
    return 1.0;
  }
  return integers && range <= LargestStep ? 1.0 : range / LargestStep;
}

int LastStep(double range, bool integers)
{
  if (!(range > SmallestDifference))
  {
    return 0;
  }
  return int(integers && range <= LargestStep ? range : LargestStep);
}

}

BrickRanges::BrickRanges(
  glm::ivec3 cellCount, double firstValue, double lastValue, bool integers, int side)
  : side(side)
  , brickCount((cellCount + side - 1) / side)
  , firstValue(firstValue)
  , valuePerStep(varimarch::ValuePerStep(lastValue - firstValue, integers))
  , lastStep(varimarch::LastStep(lastValue - firstValue, integers))
{
  const std::size_t count =
    std::size_t(this->brickCount.x) * this->brickCount.y * this->brickCount.z;
  constexpr double LargestNarrowStep = 255.0;
  if (integers && lastValue - firstValue <= LargestNarrowStep)
  {
    this->narrow.resize(count);
  }
  else
  {
    this->wide.resize(count);
  }
}

void BrickRanges::Set(std::size_t brick, Steps steps)
{
  if (this->narrow.empty())
  {
    this->wide[brick] = { steps.smallest, steps.largest };
  }
  else
  {
    this->narrow[brick] = { std::uint8_t(steps.smallest), std::uint8_t(steps.largest) };
  }
}

template <class Scalar>
BrickRanges BuildBrickRanges(const ScalarGrid<Scalar>& grid, double smallestValue,
  double largestValue, int reachVoxels, int side)
{
  const glm::ivec3 voxels = grid.Dimensions();
  BrickRanges ranges(
    grid.CellCount(), smallestValue, largestValue, std::numeric_limits<Scalar>::is_integer, side);
  const glm::ivec3 bricks = ranges.BrickCount();

  // First and last voxel along an axis that a brick's values depend on.
  const auto firstOf = [=](int brick) { return std::max(side * brick - reachVoxels, 0); };
  const auto lastOf = [=](int brick, int count)
  { return std::min(side * (brick + 1) + reachVoxels, count - 1); };
  const int rowsOfBricks = bricks.y * bricks.z;
  tbb::parallel_for(tbb::blocked_range<int>(0, rowsOfBricks),
    [&](const tbb::blocked_range<int>& rows)
    {
      ColumnRanges<Scalar> columns(voxels.x);
      for (int row = rows.begin(); row != rows.end(); ++row)
      {
        const int brickY = row % bricks.y;
        const int brickZ = row / bricks.y;
        columns.Start();
        for (int z = firstOf(brickZ); z <= lastOf(brickZ, voxels.z); ++z)
        {
          for (int y = firstOf(brickY); y <= lastOf(brickY, voxels.y); ++y)
          {
            columns.Add(grid.Row(y, z));
          }
        }
        for (int brickX = 0; brickX < bricks.x; ++brickX)
        {
          ranges.Set(std::size_t(row) * bricks.x + brickX,
            StepsOf(columns, firstOf(brickX), lastOf(brickX, voxels.x), ranges));
        }
      }
    });
  return ranges;
}

#define VARIMARCH_RANGES_OF(Scalar) \
  template BrickRanges BuildBrickRanges(const ScalarGrid<Scalar>&, double, double, int, int)
VARIMARCH_RANGES_OF(char);

VARIMARCH_RANGES_OF(signed char);

VARIMARCH_RANGES_OF(unsigned char);

VARIMARCH_RANGES_OF(short);

VARIMARCH_RANGES_OF(unsigned short);

VARIMARCH_RANGES_OF(int);

VARIMARCH_RANGES_OF(unsigned int);

VARIMARCH_RANGES_OF(long);

VARIMARCH_RANGES_OF(unsigned long);

VARIMARCH_RANGES_OF(long long);

VARIMARCH_RANGES_OF(unsigned long long);

VARIMARCH_RANGES_OF(float);

VARIMARCH_RANGES_OF(double);

#undef VARIMARCH_RANGES_OF

namespace
{

// A range of bricks along an axis, both ends included.
struct Span
{
  int first;
  int last;
};

// The voxel bricks that overlap each brick of the even grid, along one axis.
std::vector<Span> SpansOf(const UnevenAxis& axis, int brickCount, double side)
{
  constexpr double Rounding = 1e-3; // error of a shader's position [voxels]
  std::vector<Span> spans;
  for (int brick = 0; brick < brickCount; ++brick)
  {
    const double lower = axis.VoxelAt(side * brick) - Rounding;
    const double upper = axis.VoxelAt(side * (brick + 1)) + Rounding;
    spans.push_back({ std::clamp(int(std::floor(lower / side)), 0, brickCount - 1),
      std::clamp(int(std::floor(upper / side)), 0, brickCount - 1) });
  }
  return spans;
}

}

BrickRanges EvenBricks(const BrickRanges& ofVoxels, const std::vector<UnevenAxis>& axes)
{
  const glm::ivec3 count = ofVoxels.BrickCount();
  const double side = ofVoxels.Side();
  const std::vector<Span> alongX = SpansOf(axes[0], count.x, side);
  const std::vector<Span> alongY = SpansOf(axes[1], count.y, side);
  const std::vector<Span> alongZ = SpansOf(axes[2], count.z, side);
  const auto indexOf = [&](int x, int y, int z)
  { return x + std::size_t(count.x) * (y + std::size_t(count.y) * z); };
  const auto stepsOf = [&](const Span& spanX, const Span& spanY, const Span& spanZ)
  {
    BrickRanges::Steps steps = ofVoxels[indexOf(spanX.first, spanY.first, spanZ.first)];
    for (int z = spanZ.first; z <= spanZ.last; ++z)
    {
      for (int y = spanY.first; y <= spanY.last; ++y)
      {
        for (int x = spanX.first; x <= spanX.last; ++x)
        {
          steps = Union(steps, ofVoxels[indexOf(x, y, z)]);
        }
      }
    }
    return steps;
  };
  BrickRanges even = ofVoxels;
  tbb::parallel_for(0, count.z,
    [&](int z)
    {
      for (int y = 0; y < count.y; ++y)
      {
        for (int x = 0; x < count.x; ++x)
        {
          even.Set(indexOf(x, y, z), stepsOf(alongX[x], alongY[y], alongZ[z]));
        }
      }
    });
  return even;
}

}
