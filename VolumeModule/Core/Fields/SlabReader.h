#ifndef Varimarch_Core_Fields_SlabReader_h
#define Varimarch_Core_Fields_SlabReader_h

#include "Core/Blocks/BrickSource.h"
#include "Core/Fields/BrickRanges.h"

#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
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
    bool has = true;
    for (int axis = 0; axis < 3; ++axis)
    {
      has = has && (this->count[axis] > 1 || this->first[axis] == 0);
    }
    return has;
  }
};

/// Reads slabs on as many cores as there is memory for slabs. A core takes no other slab before it
/// is done with one. Slabs have whole slices; where these are so large that slabs would be thinner
/// than chunks, they are boxes of some chunks along each axis.
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
    constexpr std::int64_t MostChunks = 4;
    const auto& chunk = source.Levels().front().chunk;
    const auto threads = std::int64_t(tbb::this_task_arena::max_concurrency());
    const auto most = std::int64_t(mostBytes / sizeof(Scalar)) / threads; // voxels of a slab
    const std::int64_t slices = std::max(chunk[2], FewSlices);
    std::int64_t chunks = MostChunks;
    while (chunks > 1 && most < this->VoxelsOfChunks(chunk, chunks))
    {
      --chunks;
    }
    const std::int64_t ofSlice = std::int64_t(this->voxels.x) * this->voxels.y;
    const bool areThin = chunk[2] > 1 && most / ofSlice - 1 < chunk[2];
    if (areThin && most >= this->VoxelsOfChunks(chunk, chunks))
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        this->extent[axis] = this->Bricks(chunks * chunk[axis]);
      }
    }
    else
    {
      this->extent.z = this->Bricks(std::min(slices, most / ofSlice - 1));
    }
    const glm::ivec3 read = glm::min(this->extent, this->voxels - 1) + 1;
    const std::int64_t ofSlab = std::int64_t(read.x) * read.y * read.z;
    this->slabsAtOnce =
      int(std::clamp<std::int64_t>(std::int64_t(mostBytes / sizeof(Scalar)) / ofSlab, 1, threads));
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
  /// The largest number of voxels, at most `most`, that whole bricks have; one brick at least.
  int Bricks(std::int64_t most) const
  {
    return int(std::clamp<std::int64_t>(most / this->side, 1, (1 << 30) / this->side)) * this->side;
  }

  /// The voxels of a box of some chunks along each axis, with those that the next one begins with.
  std::int64_t VoxelsOfChunks(const std::array<std::int64_t, 3>& chunk, std::int64_t chunks) const
  {
    std::int64_t count = 1;
    for (int axis = 0; axis < 3; ++axis)
    {
      count *= std::min<std::int64_t>(this->Bricks(chunks * chunk[axis]) + 1, this->voxels[axis]);
    }
    return count;
  }

  /// The number of slabs along each axis.
  glm::ivec3 Counts() const { return (this->voxels - 1) / this->extent + 1; }
  int SlabCount() const
  {
    const glm::ivec3 counts = this->Counts();
    return counts.x * counts.y * counts.z;
  }

  static BrickSource::Box BoxOf(const StoredSlab& slab)
  {
    const glm::ivec3 behind = slab.first + slab.count;
    return { { slab.first.x, slab.first.y, slab.first.z }, { behind.x, behind.y, behind.z } };
  }

  StoredSlab SlabOf(int index) const
  {
    const glm::ivec3 counts = this->Counts();
    const glm::ivec3 number(
      index % counts.x, index / counts.x % counts.y, index / counts.x / counts.y);
    const glm::ivec3 first = number * this->extent;
    const glm::ivec3 own = glm::min(this->extent, this->voxels - first);
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
  glm::ivec3 extent; ///< own voxels of a slab
  int slabsAtOnce;
};

}

#endif
