#ifndef Varimarch_Core_Fields_RangePyramid_h
#define Varimarch_Core_Fields_RangePyramid_h

#include "Core/Geometry/ScalarGrid.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <vector>

namespace varimarch
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

}

#endif
