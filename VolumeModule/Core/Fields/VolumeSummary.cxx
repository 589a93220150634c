#include "Core/Fields/VolumeSummary.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>
#include <numeric>
#include <thread>
#include <type_traits>

namespace varimarch
{

namespace
{

constexpr int Side = BrickRanges::CellsPerSide;

glm::ivec3 VoxelCountOf(const BrickSource::Level& level)
{
  const auto& dimensions = level.dimensions;
  return { int(dimensions[0]), int(dimensions[1]), int(dimensions[2]) };
}

/// A part of the volume between two planes of bricks.
struct Slab
{
  int firstSlice;
  int sliceCount; ///< with the slice that the next slab begins with
  int ownSlices;  ///< without it
};

// Reads slabs on all cores. A core takes no other slab before it is done with one, so that memory
// suffices.
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
  }

  // Calls take(slab, its voxels) for each slab, on several cores.
  template <class Take>
  void ForEach(const std::function<void(double)>& report, Take take) const
  {
    const int slabCount = (this->voxels.z + this->slabSlices - 1) / this->slabSlices;
    const std::thread::id caller = std::this_thread::get_id();
    std::atomic<int> done = 0;
    tbb::parallel_for(0, slabCount,
      [&](int index)
      {
        const Slab slab = this->SlabOf(index);
        std::vector<Scalar> read(
          std::size_t(this->voxels.x) * this->voxels.y * std::size_t(slab.sliceCount));
        this->source.Read(0,
          { { 0, 0, slab.firstSlice },
            { this->voxels.x, this->voxels.y, slab.firstSlice + slab.sliceCount } },
          read.data());
        tbb::this_task_arena::isolate([&] { take(slab, read); });
        const int doneNow = ++done;
        if (std::this_thread::get_id() == caller)
        {
          report(double(doneNow) / slabCount);
        }
      });
  }

private:
  Slab SlabOf(int index) const
  {
    const int first = index * this->slabSlices;
    const int own = std::min(this->slabSlices, this->voxels.z - first);
    return { first, std::min(own + 1, this->voxels.z - first), own };
  }

  const BrickSource& source;
  glm::ivec3 voxels;
  int slabSlices;
};

/// Extremes of the finite values of a slab.
template <class Scalar>
struct Finite
{
  Scalar smallest = std::numeric_limits<Scalar>::max();
  Scalar largest = std::numeric_limits<Scalar>::lowest();
  bool all = true;

  void Add(Scalar value)
  {
    const bool isFinite = std::isfinite(double(value));
    this->all = this->all && isFinite;
    this->smallest = isFinite ? std::min(this->smallest, value) : this->smallest;
    this->largest = isFinite ? std::max(this->largest, value) : this->largest;
  }
};

// The range over which bricks tell values apart: known beforehand for integers.
template <class Scalar>
Finite<Scalar> RangeOf(
  const SlabReader<Scalar>& slabs, [[maybe_unused]] const std::function<void(double)>& report)
{
  Finite<Scalar> range;
  if constexpr (std::is_integral_v<Scalar>)
  {
    range.Add(std::numeric_limits<Scalar>::lowest());
    range.Add(std::numeric_limits<Scalar>::max());
  }
  else
  {
    std::mutex mutex;
    slabs.ForEach(report,
      [&](const Slab&, const std::vector<Scalar>& voxels)
      {
        Finite<Scalar> ofSlab;
        std::for_each(voxels.begin(), voxels.end(), [&](Scalar value) { ofSlab.Add(value); });
        const std::lock_guard<std::mutex> lock(mutex);
        range.smallest = std::min(range.smallest, ofSlab.smallest);
        range.largest = std::max(range.largest, ofSlab.largest);
        range.all = range.all && ofSlab.all;
      });
    if (range.smallest > range.largest)
    {
      range.smallest = range.largest = Scalar(0);
    }
  }
  return range;
}

// Puts the ranges of a slab where they belong in those of the volume.
void PutRanges(const BrickRanges& ofSlab, int firstSlice, BrickRanges& ranges)
{
  const glm::ivec3 count = ofSlab.BrickCount();
  const std::size_t perLayer = std::size_t(count.x) * count.y;
  const std::size_t first = std::size_t(firstSlice / Side) * perLayer;
  for (std::size_t brick = 0; brick < perLayer * std::size_t(count.z); ++brick)
  {
    ranges.Set(first + brick, ofSlab[brick]);
  }
}

// Only integers are counted.
template <class Scalar>
void Count(const Slab& slab, const std::vector<Scalar>& voxels, std::vector<std::int64_t>& counts,
  std::mutex& mutex)
{
  if constexpr (std::is_integral_v<Scalar>)
  {
    const std::size_t own = voxels.size() / std::size_t(slab.sliceCount) * slab.ownSlices;
    // Neighbours are often alike: with a count each they do not wait for each other. A slab has
    // fewer than 2^32 voxels.
    constexpr std::size_t Apart = 4;
    std::vector<std::uint32_t> few(Apart * counts.size());
    for (std::size_t i = 0; i < own; ++i)
    {
      const auto value = std::size_t(int(voxels[i]) - int(std::numeric_limits<Scalar>::lowest()));
      ++few[i % Apart * counts.size() + value];
    }
    const std::lock_guard<std::mutex> lock(mutex);
    for (std::size_t i = 0; i < few.size(); ++i)
    {
      counts[i % counts.size()] += few[i];
    }
  }
}

// The means of a row of cubes.
template <class Scalar>
void TakeMeans(const ScalarGrid<Scalar>& grid, int firstY, int firstZ, int count, Scalar* means)
{
  constexpr int Cube = CoarseLevel::Side;
  using Sum = std::conditional_t<std::is_integral_v<Scalar>, std::int32_t, double>;
  std::vector<Sum> columns(std::size_t(Cube) * count);
  for (int i = 0; i < Cube * Cube; ++i)
  {
    const Scalar* const voxels = grid.Row(firstY + i % Cube, firstZ + i / Cube);
    std::transform(columns.begin(), columns.end(), voxels, columns.begin(),
      [](Sum sum, Scalar voxel) { return sum + Sum(voxel); });
  }
  for (int x = 0; x < count; ++x)
  {
    const auto first = columns.begin() + Cube * x;
    const double mean = double(std::accumulate(first, first + Cube, Sum(0))) / (Cube * Cube * Cube);
    means[x] = Scalar(std::is_integral_v<Scalar> ? std::round(mean) : mean);
  }
}

// Puts the means of the cubes of a slab where they belong.
template <class Scalar>
void PutMeans(const Slab& slab, const ScalarGrid<Scalar>& grid, CoarseLevel& coarse)
{
  constexpr int Cube = CoarseLevel::Side;
  auto* const means = reinterpret_cast<Scalar*>(coarse.voxels.data());
  const glm::ivec3 count = coarse.voxelCount;
  const int firstCube = slab.firstSlice / Cube;
  for (int z = 0; z < slab.ownSlices / Cube && firstCube + z < count.z; ++z)
  {
    for (int y = 0; y < count.y; ++y)
    {
      const std::size_t row = std::size_t(firstCube + z) * count.y + y;
      TakeMeans(grid, Cube * y, Cube * z, count.x, means + row * count.x);
    }
  }
}

template <class Scalar>
void TakeExtremes(VolumeSummary& summary)
{
  const auto isThere = [](std::int64_t count) { return count > 0; };
  const auto& counts = summary.counts;
  const auto first = std::find_if(counts.begin(), counts.end(), isThere);
  const auto last = std::find_if(counts.rbegin(), counts.rend(), isThere);
  const double lowest = double(std::numeric_limits<Scalar>::lowest());
  summary.smallest = lowest + double(first - counts.begin());
  summary.largest = lowest + double(counts.rend() - last) - 1.0;
}

template <class Scalar>
VolumeSummary SummaryOf(
  const BrickSource& source, std::uint64_t mostBytes, const std::function<void(double)>& report)
{
  constexpr bool isCounted = std::is_integral_v<Scalar>;
  const SlabReader<Scalar> slabs(source, mostBytes);
  const Finite<Scalar> range = RangeOf(slabs, [&](double part) { report(0.5 * part); });
  const glm::ivec3 voxels = VoxelCountOf(source.Levels().front());
  VolumeSummary summary = UnfilledSummary(
    source.Levels().front(), source.Type(), double(range.smallest), double(range.largest));
  summary.areFinite = range.all;
  std::mutex counting;
  slabs.ForEach([&](double part) { report(isCounted ? part : 0.5 + 0.5 * part); },
    [&](const Slab& slab, const std::vector<Scalar>& read)
    {
      const ScalarGrid<Scalar> grid(read.data(), { voxels.x, voxels.y, slab.sliceCount });
      const bool isOfNoCells = slab.sliceCount == 1 && slab.firstSlice > 0;
      if (!isOfNoCells)
      {
        PutRanges(BuildBrickRanges(grid, double(range.smallest), double(range.largest)),
          slab.firstSlice, summary.ranges);
      }
      PutMeans(slab, grid, summary.coarse);
      Count(slab, read, summary.counts, counting);
    });
  if constexpr (isCounted)
  {
    TakeExtremes<Scalar>(summary);
  }
  return summary;
}

}

VolumeSummary UnfilledSummary(
  const BrickSource::Level& level, VoxelType type, double smallest, double largest)
{
  VolumeSummary summary;
  summary.smallest = smallest;
  summary.largest = largest;
  ByVoxelType(type,
    [&](auto voxel)
    {
      using Limits = std::numeric_limits<decltype(voxel)>;
      const glm::ivec3 cells = glm::max(VoxelCountOf(level) - 1, 1);
      summary.ranges = Limits::is_integer
        ? BrickRanges(cells, double(Limits::lowest()), double(Limits::max()), true)
        : BrickRanges(cells, smallest, largest, false);
      summary.counts.resize(Limits::is_integer ? std::size_t(1) << (8 * sizeof(voxel)) : 0);
      const glm::ivec3 means = VoxelCountOf(level) / CoarseLevel::Side;
      if (std::min({ means.x, means.y, means.z }) > 1)
      {
        summary.coarse.voxelCount = means;
        summary.coarse.voxels.resize(
          sizeof(voxel) * std::size_t(means.x) * means.y * std::size_t(means.z));
      }
    });
  return summary;
}

std::uint64_t BytesOfBricks(const BrickSource::Level& level, VoxelType type)
{
  std::uint64_t bricks = 1;
  for (const std::int64_t voxels : level.dimensions)
  {
    bricks *= std::uint64_t((std::max<std::int64_t>(voxels - 1, 1) + Side - 1) / Side);
  }
  constexpr std::uint64_t BytesOfField = 3; // with the distances and what is visible
  const std::uint64_t bytesOfMean = ByVoxelType(type, [](auto voxel) { return sizeof(voxel); });
  const std::uint64_t bytesOfRange = bytesOfMean == 1 ? 2 : 4;
  return bricks * (BytesOfField + bytesOfRange + bytesOfMean);
}

VolumeSummary SummaryOf(
  const BrickSource& source, std::uint64_t mostSlabBytes, const std::function<void(double)>& report)
{
  return ByVoxelType(source.Type(),
    [&](auto voxel) { return SummaryOf<decltype(voxel)>(source, mostSlabBytes, report); });
}

}
