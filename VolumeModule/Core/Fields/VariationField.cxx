#include "Core/Fields/VariationField.h"

#include "Core/Geometry/ScalarGrid.h"

#include <glm/common.hpp>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace varimarch
{
namespace
{

/// The smallest and the largest value of some voxels. A NaN may be any value.
template <class Scalar>
struct ValuesBetween
{
  Scalar lowest;
  Scalar highest;

  static ValuesBetween Of(Scalar value)
  {
    if constexpr (std::is_floating_point_v<Scalar>)
    {
      constexpr Scalar Infinite = std::numeric_limits<Scalar>::infinity();
      if (std::isnan(value))
      {
        return { -Infinite, Infinite };
      }
    }
    return { value, value };
  }

  void Add(const ValuesBetween& other)
  {
    this->lowest = std::min(this->lowest, other.lowest);
    this->highest = std::max(this->highest, other.highest);
  }
};

/// The ranges of values in cubes of 1, 2, 4, ... voxels a side, up to one that holds the volume.
/// Cube c of level l begins at voxel 2^l c. The voxels belong to the caller.
template <class Scalar>
class RangePyramid
{
public:
  explicit RangePyramid(const ScalarGrid<Scalar>& grid)
    : grid(grid)
  {
    for (glm::ivec3 count = grid.Dimensions(); count != glm::ivec3(1);)
    {
      count = (count + 1) / 2;
      this->levels.push_back({ count, {} });
      this->Fill(int(this->levels.size()));
    }
  }

  int Top() const { return int(this->levels.size()); }

  /// The number of cubes along each axis.
  glm::ivec3 Count(int level) const
  {
    return level == 0 ? this->grid.Dimensions() : this->levels[level - 1].count;
  }

  ValuesBetween<Scalar> At(int level, glm::ivec3 cube) const
  {
    return level == 0 ? ValuesBetween<Scalar>::Of(this->grid.Voxel(cube))
                      : this->levels[level - 1].At(cube);
  }

private:
  struct Level
  {
    glm::ivec3 count;
    std::vector<ValuesBetween<Scalar>> cubes;

    std::size_t Index(glm::ivec3 cube) const
    {
      return (std::size_t(cube.z) * this->count.y + cube.y) * this->count.x + cube.x;
    }
    const ValuesBetween<Scalar>& At(glm::ivec3 cube) const
    {
      return this->cubes[this->Index(cube)];
    }
  };

  void Fill(int level)
  {
    Level& filled = this->levels[level - 1];
    const glm::ivec3 count = filled.count;
    filled.cubes.resize(std::size_t(count.x) * count.y * count.z);
    tbb::parallel_for(0, count.z,
      [&](int z)
      {
        for (int y = 0; y < count.y; ++y)
        {
          for (int x = 0; x < count.x; ++x)
          {
            filled.cubes[filled.Index({ x, y, z })] = this->Joined(level - 1, { x, y, z });
          }
        }
      });
  }

  /// The range of the up to eight cubes of a level that make one of the next.
  ValuesBetween<Scalar> Joined(int level, glm::ivec3 cube) const
  {
    const glm::ivec3 first = 2 * cube;
    const glm::ivec3 last = glm::min(first + 1, this->Count(level) - 1);
    ValuesBetween<Scalar> joined = this->At(level, first);
    for (int i = 1; i < 8; ++i)
    {
      joined.Add(this->At(level, glm::min(first + glm::ivec3(i & 1, i >> 1 & 1, i >> 2), last)));
    }
    return joined;
  }

  ScalarGrid<Scalar> grid;
  std::vector<Level> levels; ///< from cubes of two voxels a side on
};

/// Squares of distances, so that they are whole numbers.
struct EuclideanMeasure
{
  static int OfVoxels(int voxels) { return voxels * voxels; }
  static int Joined(int x, int y, int z) { return x + y + z; }
  static int WholeVoxels(int measure) { return int(std::sqrt(double(measure))); }
};

struct ChebyshevMeasure
{
  static int OfVoxels(int voxels) { return voxels; }
  static int Joined(int x, int y, int z) { return std::max({ x, y, z }); }
  static int WholeVoxels(int measure) { return measure; }
};

/// Finds the nearest voxel with a different value. Cubes of the pyramid are left out if they are
/// not closer than a voxel that is known, or have no different value; nearer ones are searched
/// first. Along a sweep the nearest voxels of neighbours are known and nearly always the right
/// ones, so that a search mostly confirms them.
template <class Scalar, class Measure>
class NearestDifference
{
public:
  NearestDifference(
    const ScalarGrid<Scalar>& grid, const RangePyramid<Scalar>& ranges, double tolerance)
    : grid(grid)
    , ranges(ranges)
    , tolerance(tolerance)
  {
  }

  void Begin(glm::ivec3 newVoxel)
  {
    this->voxel = newVoxel;
    this->value = double(this->grid.Voxel(newVoxel));
    this->nearest.reset();
    this->measure = Measure::OfVoxels(VariationField::Farthest);
  }

  /// Takes a voxel into account.
  void Try(glm::ivec3 other)
  {
    const glm::ivec3 apart = other - this->voxel;
    const int far = Measure::Joined(Measure::OfVoxels(std::abs(apart.x)),
      Measure::OfVoxels(std::abs(apart.y)), Measure::OfVoxels(std::abs(apart.z)));
    if (other != this->voxel && far < this->measure && this->Differs(0, other))
    {
      this->nearest = other;
      this->measure = far;
    }
  }

  /// Searches all voxels that are closer than those tried.
  void Search()
  {
    const int reach = Measure::WholeVoxels(this->measure - 1);
    if (reach == 0)
    {
      return; // no voxel is closer than a neighbour
    }
    int level = 0;
    while (level < this->ranges.Top() && (1 << level) < 2 * reach + 1)
    {
      ++level;
    }
    const glm::ivec3 first = glm::max(this->voxel - reach, glm::ivec3(0)) >> level;
    const glm::ivec3 last =
      glm::min(this->voxel + reach, this->ranges.Count(0) - 1) >> level; // at most first + 1
    this->SearchCubes(level, first, last);
  }

  const std::optional<glm::ivec3>& Nearest() const { return this->nearest; }
  int WholeVoxels() const { return Measure::WholeVoxels(this->measure); }

private:
  bool Differs(int level, glm::ivec3 cube) const
  {
    const ValuesBetween<Scalar> values = this->ranges.At(level, cube);
    return !(this->value - double(values.lowest) < this->tolerance &&
      double(values.highest) - this->value < this->tolerance);
  }

  /// One or two cubes along an axis, the nearer one first, with the measures of the gaps between
  /// them and the voxel.
  struct CubesOfAxis
  {
    int count;
    int cubes[2];
    int measures[2];
  };

  CubesOfAxis CubesAlong(int axis, int level, int first, int last) const
  {
    const int place = this->voxel[axis];
    const auto measureOf = [&](int cube)
    {
      const int lower = cube << level;
      return Measure::OfVoxels(std::max({ lower - place, place - lower - ((1 << level) - 1), 0 }));
    };
    const int nearer = std::clamp(place >> level, first, last);
    const int farther = first + last - nearer;
    return { last - first + 1, { nearer, farther }, { measureOf(nearer), measureOf(farther) } };
  }

  /// Searches up to eight cubes, nearer ones first.
  void SearchCubes(int level, glm::ivec3 first, glm::ivec3 last)
  {
    const CubesOfAxis x = this->CubesAlong(0, level, first.x, last.x);
    const CubesOfAxis y = this->CubesAlong(1, level, first.y, last.y);
    const CubesOfAxis z = this->CubesAlong(2, level, first.z, last.z);
    const auto isCloser = [&](int i, int j, int k)
    { return Measure::Joined(x.measures[i], y.measures[j], z.measures[k]) < this->measure; };
    for (int k = 0; k < z.count && isCloser(0, 0, k); ++k)
    {
      for (int j = 0; j < y.count && isCloser(0, j, k); ++j)
      {
        for (int i = 0; i < x.count && isCloser(i, j, k); ++i)
        {
          const glm::ivec3 cube(x.cubes[i], y.cubes[j], z.cubes[k]);
          if (this->Differs(level, cube))
          {
            this->SearchIn(level, cube);
          }
        }
      }
    }
  }

  void SearchIn(int level, glm::ivec3 cube)
  {
    if (level == 0)
    {
      this->Try(cube);
      return;
    }
    const glm::ivec3 first = 2 * cube;
    this->SearchCubes(level - 1, first, glm::min(first + 1, this->ranges.Count(level - 1) - 1));
  }

  const ScalarGrid<Scalar>& grid;
  const RangePyramid<Scalar>& ranges;
  double tolerance;
  glm::ivec3 voxel = glm::ivec3(0);
  double value = 0.0;
  std::optional<glm::ivec3> nearest;
  int measure = 0;
};

/// Fills one slice, sweeping along x and then along y.
template <class Scalar, class Measure>
void FillSlice(
  NearestDifference<Scalar, Measure> search, glm::ivec3 count, int z, std::uint8_t* distances)
{
  // Nearest voxels of the row before, which those of this row replace.
  std::vector<std::optional<glm::ivec3>> nearestOfRow(count.x);
  for (int y = 0; y < count.y; ++y)
  {
    std::optional<glm::ivec3> nearestBefore;
    for (int x = 0; x < count.x; ++x)
    {
      search.Begin({ x, y, z });
      for (const std::optional<glm::ivec3>& known : { nearestBefore, nearestOfRow[x] })
      {
        if (known)
        {
          search.Try(*known);
        }
      }
      search.Search();
      nearestBefore = nearestOfRow[x] = search.Nearest();
      *distances++ = std::uint8_t(search.WholeVoxels());
    }
  }
}

template <class Measure, class Scalar>
VariationField BuildBy(const ScalarGrid<Scalar>& grid, double tolerance)
{
  const RangePyramid<Scalar> ranges(grid);
  const glm::ivec3 count = grid.Dimensions();
  VariationField field{ count, std::vector<std::uint8_t>(grid.VoxelCount()) };
  tbb::parallel_for(0, count.z,
    [&](int z)
    {
      FillSlice(NearestDifference<Scalar, Measure>(grid, ranges, tolerance), count, z,
        &field.voxels[std::size_t(z) * count.x * count.y]);
    });
  return field;
}

}

template <class Scalar>
VariationField BuildVariationField(
  const ScalarGrid<Scalar>& grid, double tolerance, VoxelDistance distance)
{
  if (!(tolerance >= 0.0))
  {
    throw std::invalid_argument(
      "Cannot build a variation field: expected a tolerance of at least 0, found " +
      std::to_string(tolerance));
  }
  return distance == VoxelDistance::Euclidean ? BuildBy<EuclideanMeasure>(grid, tolerance)
                                              : BuildBy<ChebyshevMeasure>(grid, tolerance);
}

#define VARIMARCH_VARIATION_OF(Scalar) \
  template VariationField BuildVariationField(const ScalarGrid<Scalar>&, double, VoxelDistance)
VARIMARCH_VARIATION_OF(char);

VARIMARCH_VARIATION_OF(signed char);

VARIMARCH_VARIATION_OF(unsigned char);

VARIMARCH_VARIATION_OF(short);

VARIMARCH_VARIATION_OF(unsigned short);

VARIMARCH_VARIATION_OF(int);

VARIMARCH_VARIATION_OF(unsigned int);

VARIMARCH_VARIATION_OF(long);

VARIMARCH_VARIATION_OF(unsigned long);

VARIMARCH_VARIATION_OF(long long);

VARIMARCH_VARIATION_OF(unsigned long long);

VARIMARCH_VARIATION_OF(float);

VARIMARCH_VARIATION_OF(double);

#undef VARIMARCH_VARIATION_OF

}
