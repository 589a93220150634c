#ifndef Varimarch_Core_Fields_SlabRanges_h
#define Varimarch_Core_Fields_SlabRanges_h

#include "Core/Fields/SlabReader.h"
#include "Core/Fields/StepsUnion.h"
#include "Core/Look/ValueRange.h"

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <mutex>

namespace varimarch
{

/// Puts the ranges of a volume together from those of its slabs, so that each voxel is read for
/// one slab only. A brick has its far faces in common with the next bricks: the first voxels of a
/// slab belong to bricks of the slabs before it too.
class SlabRanges
{
public:
  /// @param ranges  ranges of the whole volume, which are known when all slabs are put there
  explicit SlabRanges(BrickRanges& ranges)
    : ranges(ranges)
  {
    const glm::ivec3 count = ranges.BrickCount();
    for (std::size_t brick = 0; brick < std::size_t(count.x) * count.y * count.z; ++brick)
    {
      ranges.Set(brick, Nothing);
    }
  }

  /// Adds the voxels of a slab. May be called from several threads at the same time.
  /// @param extremes  the values between which ranges are told apart
  template <class Scalar>
  void Add(const VoxelSlab& slab, const ScalarGrid<Scalar>& grid, const ValueRange& extremes)
  {
    constexpr int Ways = 8; // along each axis the whole slab, or its first voxels alone
    for (int way = 0; way < Ways; ++way)
    {
      const glm::ivec3 alone(way & 1, way >> 1 & 1, way >> 2 & 1);
      if (HasBricks(slab, alone))
      {
        const VoxelRegion region = { glm::ivec3(0),
          glm::mix(slab.count, glm::ivec3(1), glm::bvec3(alone)) };
        this->Put(BuildBrickRanges(
                    grid.Part(region), extremes.lower, extremes.upper, 0, this->ranges.Side()),
          slab.first / this->ranges.Side() - alone);
      }
    }
  }

  /// Adds a slab whose voxels all have the same value.
  void Add(const VoxelSlab& slab, BrickRanges::Steps steps)
  {
    const int side = this->ranges.Side();
    const glm::ivec3 first = glm::max(slab.first - 1, 0) / side;
    const glm::ivec3 last =
      glm::min((slab.first + slab.count - 1) / side, this->ranges.BrickCount() - 1);
    const glm::ivec3 count = last - first + 1;
    const std::lock_guard<std::mutex> lock(this->mutex);
    for (int row = 0; row < count.y * count.z; ++row)
    {
      const std::size_t begin =
        this->RowOf(first + glm::ivec3(0, row % count.y, row / count.y)) + std::size_t(first.x);
      for (std::size_t brick = begin; brick < begin + std::size_t(count.x); ++brick)
      {
        this->Include(brick, steps);
      }
    }
  }

private:
  /// The range of a brick without voxels yet, which no brick with voxels has.
  static constexpr BrickRanges::Steps Nothing = { 255, 0 };

  /// True if there are bricks to which the slab, or its first voxels along some axes, belong.
  static bool HasBricks(const VoxelSlab& slab, const glm::ivec3& alone)
  {
    bool has = true;
    for (int axis = 0; axis < 3; ++axis)
    {
      has = has &&
        (slab.first[axis] == 0 ? alone[axis] == 0 : alone[axis] == 1 || slab.count[axis] > 1);
    }
    return has;
  }

  std::size_t RowOf(const glm::ivec3& brick) const
  {
    const glm::ivec3 all = this->ranges.BrickCount();
    return (std::size_t(brick.z) * all.y + brick.y) * all.x;
  }

  void Put(const BrickRanges& part, const glm::ivec3& first)
  {
    const glm::ivec3 count = part.BrickCount();
    const std::lock_guard<std::mutex> lock(this->mutex);
    std::size_t brick = 0;
    for (int row = 0; row < count.y * count.z; ++row)
    {
      const std::size_t begin =
        this->RowOf(first + glm::ivec3(0, row % count.y, row / count.y)) + std::size_t(first.x);
      for (int x = 0; x < count.x; ++x, ++brick)
      {
        this->Include(begin + std::size_t(x), part[brick]);
      }
    }
  }

  void Include(std::size_t brick, BrickRanges::Steps steps)
  {
    const BrickRanges::Steps before = this->ranges[brick];
    const bool isFirst = before.smallest == Nothing.smallest && before.largest == Nothing.largest;
    this->ranges.Set(brick, isFirst ? steps : Union(before, steps));
  }

  BrickRanges& ranges;
  std::mutex mutex;
};

}

#endif
