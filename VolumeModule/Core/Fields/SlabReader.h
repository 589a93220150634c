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

/// A box of voxels that are read together. It begins where bricks do.
struct VoxelSlab
{
  glm::ivec3 first; ///< its first voxel
  glm::ivec3 count; ///< voxels along each axis
  bool isStored;    ///< false if all its voxels have the fill value
};

/// Reads a volume in slabs, on as many cores as there is memory for slabs. A core takes no other
/// slab before it is done with one. Each slab is some whole chunks, so that each chunk is read
/// once, unless the memory is too small for them, or too many chunks are needed to fill whole
/// bricks.
template <class Scalar>
class SlabReader
{
public:
  /// @param mostBytes  voxels that are in memory at the same time [bytes]
  /// @param side  cells along each side of a brick
  SlabReader(const BrickSource& source, std::uint64_t mostBytes, int side)
    : source(source)
    , side(side)
    , voxels(VoxelCountOf(source.Levels().front()))
  {
    constexpr std::int64_t Wanted = 1 << 21; // voxels for which a decoder is worth asking
    const auto threads = std::int64_t(tbb::this_task_arena::max_concurrency());
    const auto most = std::int64_t(mostBytes / sizeof(Scalar));
    this->TakeWholeChunks();
    this->Grow(std::min(Wanted, most / threads));
    this->Shrink(most / threads);
    const std::int64_t ofSlab = VoxelsOf(glm::min(this->extent, this->voxels));
    this->slabsAtOnce = int(std::clamp<std::int64_t>(most / ofSlab, 1, threads));
  }

  /// True if all slabs are stored.
  bool HaveAll() const { return this->StoredCount() == this->SlabCount(); }

  /// Calls take(slab, its voxels) for each slab, on several cores. There are no voxels for slabs
  /// that are not stored.
  template <class Take>
  void ForEach(const std::function<void(double)>& report, Take take) const
  {
    const int slabCount = this->SlabCount();
    const int storedCount = this->StoredCount();
    const std::thread::id caller = std::this_thread::get_id();
    std::atomic<int> done = 0;
    const auto readOne = [&](int index)
    {
      const VoxelSlab slab = this->SlabOf(index);
      std::vector<Scalar> read(slab.isStored ? std::size_t(VoxelsOf(slab.count)) : 0);
      if (slab.isStored)
      {
        this->source.Read(0, BoxOf(slab), read.data());
      }
      tbb::this_task_arena::isolate([&] { take(slab, read); });
      done += slab.isStored ? 1 : 0;
      if (std::this_thread::get_id() == caller)
      {
        report(double(done) / std::max(storedCount, 1));
      }
    };
    tbb::task_arena arena(this->slabsAtOnce);
    arena.execute([&] { tbb::parallel_for(0, slabCount, readOne); });
  }

private:
  static std::int64_t VoxelsOf(const glm::ivec3& size)
  {
    return std::int64_t(size.x) * size.y * size.z;
  }

  static BrickSource::Box BoxOf(const VoxelSlab& slab)
  {
    const glm::ivec3 behind = slab.first + slab.count;
    return { { slab.first.x, slab.first.y, slab.first.z }, { behind.x, behind.y, behind.z } };
  }

  /// A number of voxels, at least as many, that whole bricks have.
  int Bricks(std::int64_t least) const
  {
    constexpr std::int64_t Most = 1 << 30;
    return int((std::min(least, Most) + this->side - 1) / this->side) * this->side;
  }

  /// The fewest chunks that are whole bricks, or nearly.
  void TakeWholeChunks()
  {
    constexpr std::int64_t MostChunks = 4;
    const auto& chunk = this->source.Levels().front().chunk;
    for (int axis = 0; axis < 3; ++axis)
    {
      std::int64_t wanted = chunk[axis];
      while (wanted % this->side != 0 && wanted < MostChunks * chunk[axis])
      {
        wanted += chunk[axis];
      }
      this->extent[axis] = this->Bricks(std::min<std::int64_t>(wanted, this->voxels[axis]));
    }
  }

  /// Takes more chunks, as long as there are no more than some voxels.
  void Grow(std::int64_t most)
  {
    bool grows = true;
    while (grows)
    {
      int axis = 0;
      for (int other = 1; other < 3; ++other)
      {
        const bool isCovered = this->extent[axis] >= this->voxels[axis];
        const bool isOpen = this->extent[other] < this->voxels[other];
        axis = isOpen && (isCovered || this->extent[other] < this->extent[axis]) ? other : axis;
      }
      grows = this->extent[axis] < this->voxels[axis] && 2 * VoxelsOf(this->extent) <= most;
      this->extent[axis] *= grows ? 2 : 1;
    }
  }

  /// Takes thinner slabs until there are at most some voxels, but one brick at least.
  void Shrink(std::int64_t most)
  {
    for (int axis = 2; axis >= 0; --axis)
    {
      const std::int64_t ofLayer = VoxelsOf(this->extent) / this->extent[axis];
      const std::int64_t layers =
        std::max<std::int64_t>(most / ofLayer / this->side, 1) * this->side;
      this->extent[axis] = int(std::min<std::int64_t>(this->extent[axis], layers));
    }
  }

  /// The number of slabs along each axis.
  glm::ivec3 Counts() const { return (this->voxels - 1) / this->extent + 1; }
  int SlabCount() const { return int(VoxelsOf(this->Counts())); }

  int StoredCount() const
  {
    int count = 0;
    for (int i = 0; i < this->SlabCount(); ++i)
    {
      count += this->SlabOf(i).isStored ? 1 : 0;
    }
    return count;
  }

  VoxelSlab SlabOf(int index) const
  {
    const glm::ivec3 counts = this->Counts();
    const glm::ivec3 number(
      index % counts.x, index / counts.x % counts.y, index / counts.x / counts.y);
    VoxelSlab slab = { number * this->extent, this->extent, true };
    slab.count = glm::min(slab.count, this->voxels - slab.first);
    const BrickSource::Box stored = this->source.Occupied(BoxOf(slab));
    slab.isStored = stored.lower[0] < stored.upper[0];
    return slab;
  }

  const BrickSource& source;
  int side;
  glm::ivec3 voxels;
  glm::ivec3 extent = glm::ivec3(1); ///< voxels of a slab along each axis, in whole bricks
  int slabsAtOnce = 1;
};

}

#endif
