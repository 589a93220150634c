#ifndef Varimarch_Core_Fields_SlabReader_h
#define Varimarch_Core_Fields_SlabReader_h

#include "Core/Blocks/BrickSource.h"
#include "Core/Fields/BrickRanges.h"

#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <thread>
#include <vector>

namespace varimarch
{

/// The voxels of a level along each axis.
inline glm::ivec3 VoxelCountOf(const BrickSource::Level& level)
{
  const auto& dimensions = level.dimensions;
  return { int(dimensions[0]), int(dimensions[1]), int(dimensions[2]) };
}

/// A part of the volume between planes of bricks, without the bricks around it of which nothing is
/// stored.
struct StoredSlab
{
  glm::ivec3 first; ///< its first voxel, which begins a brick
  glm::ivec3 count; ///< voxels along each axis, with those that the next slabs begin with
  glm::ivec3 own;   ///< voxels without those

  std::size_t Voxels() const
  {
    return std::size_t(this->count.x) * std::size_t(this->count.y) * std::size_t(this->count.z);
  }

  /// False for voxels at the end that belong to the cells of the slab before.
  bool HasCells() const
  {
    const bool isLastRow = this->count.y == 1 && this->first.y > 0;
    const bool isLastSlice = this->count.z == 1 && this->first.z > 0;
    return !isLastRow && !isLastSlice;
  }
};

/// Reads slabs on as many cores as there is memory for slabs. A core takes no other slab before it
/// is done with one. Slabs have whole chunks if there is memory for a row of them along x.
template <class Scalar>
class SlabReader
{
public:
  /// @param side  cells along each side of a brick
  SlabReader(const BrickSource& source, std::uint64_t mostBytes, int side)
    : source(source)
    , side(side)
    , voxels(VoxelCountOf(source.Levels().front()))
    , extent(this->voxels)
  {
    constexpr std::int64_t FewSlices = 16;
    const auto& chunk = source.Levels().front().chunk;
    const auto threads = std::int64_t(tbb::this_task_arena::max_concurrency());
    const std::int64_t rowBytes = std::int64_t(sizeof(Scalar)) * this->voxels.x;
    const auto rows = std::int64_t(mostBytes) / threads / rowBytes; // rows that a slab may have
    const std::int64_t slices = std::max(chunk[2], FewSlices);
    const bool hasWholeSlices = rows >= (slices + 1) * this->voxels.y;
    const bool hasWholeChunks = rows >= (slices + 1) * (chunk[1] + 1);
    this->extent.y =
      hasWholeChunks && !hasWholeSlices ? this->Bricks(rows / (slices + 1) - 1) : this->voxels.y;
    this->extent.z =
      this->Bricks(std::min(slices, rows / std::min(this->extent.y + 1, this->voxels.y) - 1));
    const std::int64_t slabBytes =
      rowBytes * std::min(this->extent.y + 1, this->voxels.y) * std::int64_t(this->extent.z + 1);
    this->slabsAtOnce =
      int(std::clamp<std::int64_t>(std::int64_t(mostBytes) / slabBytes, 1, threads));
  }

  /// True if the slabs have all voxels.
  bool HaveAll() const
  {
    std::int64_t own = 0;
    for (int i = 0; i < this->SlabCount(); ++i)
    {
      const glm::ivec3 count = this->SlabOf(i).own;
      own += std::int64_t(count.x) * count.y * count.z;
    }
    return own == std::int64_t(this->voxels.x) * this->voxels.y * this->voxels.z;
  }

  /// Calls take(slab, its voxels) for each slab, on several cores.
  template <class Take>
  void ForEach(const std::function<void(double)>& report, Take take) const
  {
    const int slabCount = this->SlabCount();
    const std::thread::id caller = std::this_thread::get_id();
    std::atomic<int> done = 0;
    const auto readOne = [&](int index)
    {
      const StoredSlab slab = this->SlabOf(index);
      if (slab.Voxels() > 0)
      {
        std::vector<Scalar> read(slab.Voxels());
        this->source.Read(0, BoxOf(slab), read.data());
        tbb::this_task_arena::isolate([&] { take(slab, read); });
      }
      const int doneNow = ++done;
      if (std::this_thread::get_id() == caller)
      {
        report(double(doneNow) / slabCount);
      }
    };
    tbb::task_arena arena(this->slabsAtOnce);
    arena.execute([&] { tbb::parallel_for(0, slabCount, readOne); });
  }

private:
  /// As many voxels as whole bricks have, one at least.
  int Bricks(std::int64_t most) const
  {
    return int(std::max<std::int64_t>(most / this->side, 1)) * this->side;
  }

  int StripCount() const { return (this->voxels.y + this->extent.y - 1) / this->extent.y; }
  int SlabCount() const
  {
    return this->StripCount() * ((this->voxels.z + this->extent.z - 1) / this->extent.z);
  }

  static BrickSource::Box BoxOf(const StoredSlab& slab)
  {
    const glm::ivec3 behind = slab.first + slab.count;
    return { { slab.first.x, slab.first.y, slab.first.z }, { behind.x, behind.y, behind.z } };
  }

  StoredSlab SlabOf(int index) const
  {
    const glm::ivec3 first(
      0, index % this->StripCount() * this->extent.y, index / this->StripCount() * this->extent.z);
    const glm::ivec3 own =
      glm::min(glm::ivec3(this->voxels.x, this->extent.y, this->extent.z), this->voxels - first);
    StoredSlab slab = { first, glm::min(own + 1, this->voxels - first), own };
    const BrickSource::Box stored = this->source.Occupied(BoxOf(slab));
    const glm::ivec3 end = first + slab.count;
    for (int axis = 0; axis < 2; ++axis)
    {
      // A voxel between two bricks belongs to both.
      const auto lower = int(stored.lower[axis]);
      const auto upper = int(stored.upper[axis]);
      slab.first[axis] = std::max(std::max(lower - 1, 0) / this->side * this->side, first[axis]);
      const int behind =
        std::min((upper - 1) / this->side * this->side + this->side + 1, end[axis]);
      slab.count[axis] = lower < upper ? behind - slab.first[axis] : 0;
      slab.own[axis] = std::clamp(first[axis] + own[axis] - slab.first[axis], 0, slab.count[axis]);
    }
    return slab;
  }

  const BrickSource& source;
  int side;
  glm::ivec3 voxels;
  glm::ivec3 extent; ///< own voxels of a slab along y and z
  int slabsAtOnce;
};

}

#endif
