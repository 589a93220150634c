#ifndef Varimarch_Core_Fields_SlabReader_h
#define Varimarch_Core_Fields_SlabReader_h

#include "Core/Blocks/BrickSource.h"
#include "Core/Fields/BrickRanges.h"

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

/// A part of the volume between two planes of bricks, without the bricks around it of which nothing
/// is stored.
struct StoredSlab
{
  glm::ivec3 first; ///< its first voxel, which begins a brick
  glm::ivec3 count; ///< voxels along each axis, with the slice that the next slab begins with
  int ownSlices;    ///< slices without that

  std::size_t Voxels() const
  {
    return std::size_t(this->count.x) * std::size_t(this->count.y) * std::size_t(this->count.z);
  }
};

/// Reads slabs on as many cores as there is memory for slabs. A core takes no other slab before it
/// is done with one.
template <class Scalar>
class SlabReader
{
public:
  SlabReader(const BrickSource& source, std::uint64_t mostBytes)
    : source(source)
    , voxels(VoxelCountOf(source.Levels().front()))
  {
    const std::uint64_t sliceBytes =
      sizeof(Scalar) * std::uint64_t(this->voxels.x) * std::uint64_t(this->voxels.y);
    const auto threads = std::uint64_t(tbb::this_task_arena::max_concurrency());
    const std::uint64_t slices = std::max<std::uint64_t>(mostBytes / threads / sliceBytes, 1) - 1;
    const auto chunk = std::uint64_t(source.Levels().front().chunk[2]);
    const std::uint64_t wanted =
      std::min<std::uint64_t>(std::max<std::uint64_t>(chunk, 16), slices);
    this->slabSlices = int(std::max<std::uint64_t>(wanted / Side, 1)) * Side;
    const std::uint64_t slabBytes = sliceBytes * std::uint64_t(this->slabSlices + 1);
    this->slabsAtOnce = int(std::clamp<std::uint64_t>(mostBytes / slabBytes, 1, threads));
  }

  /// True if the slabs have all voxels.
  bool HaveAll() const
  {
    bool haveAll = true;
    for (int i = 0; i < this->SlabCount(); ++i)
    {
      const glm::ivec3 count = this->SlabOf(i).count;
      haveAll = haveAll && count.x == this->voxels.x && count.y == this->voxels.y;
    }
    return haveAll;
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
  static constexpr int Side = BrickRanges::CellsPerSide;

  int SlabCount() const { return (this->voxels.z + this->slabSlices - 1) / this->slabSlices; }

  static BrickSource::Box BoxOf(const StoredSlab& slab)
  {
    const glm::ivec3 behind = slab.first + slab.count;
    return { { slab.first.x, slab.first.y, slab.first.z }, { behind.x, behind.y, behind.z } };
  }

  StoredSlab SlabOf(int index) const
  {
    const int first = index * this->slabSlices;
    const int own = std::min(this->slabSlices, this->voxels.z - first);
    StoredSlab slab = { { 0, 0, first },
      { this->voxels.x, this->voxels.y, std::min(own + 1, this->voxels.z - first) }, own };
    const BrickSource::Box stored = this->source.Occupied(BoxOf(slab));
    for (int axis = 0; axis < 2; ++axis)
    {
      // A voxel between two bricks belongs to both.
      const auto lower = int(stored.lower[axis]);
      const auto upper = int(stored.upper[axis]);
      slab.first[axis] = std::max(lower - 1, 0) / Side * Side;
      const int behind = std::min((upper - 1) / Side * Side + Side + 1, this->voxels[axis]);
      slab.count[axis] = lower < upper ? behind - slab.first[axis] : 0;
    }
    return slab;
  }

  const BrickSource& source;
  glm::ivec3 voxels;
  int slabSlices;
  int slabsAtOnce;
};

}

#endif
