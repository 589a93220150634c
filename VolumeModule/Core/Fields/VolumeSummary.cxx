#include "Core/Fields/VolumeSummary.h"

#include "Core/Blocks/BrickSource.h"
#include "Core/Fields/BrickRanges.h"
#include "Core/Look/ValueRange.h"

#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <mutex>
#include <numeric>
#include <thread>
#include <type_traits>
#include <vector>

namespace varimarch
{
namespace
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
Finite<Scalar> RangeOf(const SlabReader<Scalar>& slabs, [[maybe_unused]] double fill,
  [[maybe_unused]] const std::function<void(double)>& report)
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
      [&](const VoxelSlab&, const std::vector<Scalar>& voxels)
      {
        Finite<Scalar> ofSlab;
        std::for_each(voxels.begin(), voxels.end(), [&](Scalar value) { ofSlab.Add(value); });
        const std::lock_guard<std::mutex> lock(mutex);
        range.smallest = std::min(range.smallest, ofSlab.smallest);
        range.largest = std::max(range.largest, ofSlab.largest);
        range.all = range.all && ofSlab.all;
      });
    if (!slabs.HaveAll())
    {
      range.Add(Scalar(fill));
    }
    if (range.smallest > range.largest)
    {
      range.smallest = range.largest = Scalar(0);
    }
  }
  return range;
}

// The range of a brick whose voxels all have one value.
template <class Scalar>
BrickRanges::Steps StepsOfFill(double value, const Finite<Scalar>& range)
{
  const std::vector<Scalar> cell(8, Scalar(value));
  const ScalarGrid<Scalar> grid(cell.data(), glm::ivec3(2));
  return BuildBrickRanges(grid, double(range.smallest), double(range.largest))[0];
}

// Only integers are counted.
template <class Scalar>
void Count(const VoxelSlab& slab, const ScalarGrid<Scalar>& grid, std::vector<std::int64_t>& counts,
  std::mutex& mutex)
{
  if constexpr (std::is_integral_v<Scalar>)
  {
    // Neighbours are often alike: with a count each they do not wait for each other. A slab has
    // fewer than 2^32 voxels.
    constexpr int Apart = 4;
    std::vector<std::uint32_t> few(Apart * counts.size());
    for (int row = 0; row < slab.count.y * slab.count.z; ++row)
    {
      const Scalar* const voxels = grid.Row(row % slab.count.y, row / slab.count.y);
      for (int x = 0; x < slab.count.x; ++x)
      {
        const auto value = std::size_t(int(voxels[x]) - int(std::numeric_limits<Scalar>::lowest()));
        ++few[std::size_t(x % Apart) * counts.size() + value];
      }
    }
    const std::lock_guard<std::mutex> lock(mutex);
    for (std::size_t i = 0; i < few.size(); ++i)
    {
      counts[i % counts.size()] += few[i];
    }
  }
}

// Counts the voxels that were not read.
template <class Scalar>
void CountFill(const BrickSource& source, std::vector<std::int64_t>& counts)
{
  const auto& size = source.Levels().front().dimensions;
  const std::int64_t read = std::accumulate(counts.begin(), counts.end(), std::int64_t(0));
  const auto fill = Scalar(source.Fill());
  counts[std::size_t(int(fill) - int(std::numeric_limits<Scalar>::lowest()))] +=
    size[0] * size[1] * size[2] - read;
}

/// Cubes of voxels side by side along x, from x = 0 on.
struct RowOfCubes
{
  int firstY;
  int firstZ;
  int count;
  int side; ///< voxels along each side of a cube
};

template <class Scalar>
void TakeMeans(const ScalarGrid<Scalar>& grid, const RowOfCubes& cubes, Scalar* means)
{
  using Sum = std::conditional_t<std::is_integral_v<Scalar>, std::int32_t, double>;
  const int side = cubes.side;
  std::vector<Sum> columns(std::size_t(side) * cubes.count);
  for (int i = 0; i < side * side; ++i)
  {
    const Scalar* const voxels = grid.Row(cubes.firstY + i % side, cubes.firstZ + i / side);
    std::transform(columns.begin(), columns.end(), voxels, columns.begin(),
      [](Sum sum, Scalar voxel) { return sum + Sum(voxel); });
  }
  for (int x = 0; x < cubes.count; ++x)
  {
    const auto first = columns.begin() + side * x;
    const double mean = double(std::accumulate(first, first + side, Sum(0))) / (side * side * side);
    means[x] = Scalar(std::is_integral_v<Scalar> ? std::round(mean) : mean);
  }
}

// Puts the means of the cubes of a slab where they belong.
template <class Scalar>
void PutMeans(const VoxelSlab& slab, const ScalarGrid<Scalar>& grid, CoarseLevel& coarse)
{
  const int side = coarse.side;
  auto* const means = reinterpret_cast<Scalar*>(coarse.voxels.data());
  const glm::ivec3 count = coarse.voxelCount;
  const glm::ivec3 first = slab.first / side;
  const glm::ivec3 own = glm::min(slab.count / side, count - first);
  for (int z = 0; z < own.z; ++z)
  {
    for (int y = 0; y < own.y; ++y)
    {
      const std::size_t row = std::size_t(first.z + z) * count.y + first.y + y;
      TakeMeans(grid, { side * y, side * z, own.x, side }, means + row * count.x + first.x);
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
VolumeSummary SummaryOf(const BrickSource& source, const SummaryOptions& options,
  const std::function<void(double)>& report)
{
  constexpr bool isCounted = std::is_integral_v<Scalar>;
  const SlabReader<Scalar> slabs(source, options.mostSlabBytes, options.side);
  const Finite<Scalar> range =
    RangeOf(slabs, source.Fill(), [&](double part) { report(0.5 * part); });
  const ValueRange extremes{ double(range.smallest), double(range.largest) };
  VolumeSummary summary =
    UnfilledSummary(source.Levels().front(), source.Type(), extremes, options.side);
  summary.areFinite = range.all;
  // Means of slabs that are not stored.
  auto* const means = reinterpret_cast<Scalar*>(summary.coarse.voxels.data());
  std::fill_n(means, summary.coarse.voxels.size() / sizeof(Scalar), Scalar(source.Fill()));
  const BrickRanges::Steps ofFill = StepsOfFill(source.Fill(), range);
  SlabRanges ranges(summary.ranges);
  std::mutex counting;
  slabs.ForEach([&](double part) { report(isCounted ? part : 0.5 + 0.5 * part); },
    [&](const VoxelSlab& slab, const std::vector<Scalar>& read)
    {
      if (!slab.isStored)
      {
        ranges.Add(slab, ofFill);
        return;
      }
      const ScalarGrid<Scalar> grid(read.data(), slab.count);
      ranges.Add(slab, grid, extremes);
      PutMeans(slab, grid, summary.coarse);
      Count(slab, grid, summary.counts, counting);
    });
  if constexpr (isCounted)
  {
    CountFill<Scalar>(source, summary.counts);
    TakeExtremes<Scalar>(summary);
  }
  return summary;
}

}

VolumeSummary UnfilledSummary(
  const BrickSource::Level& level, VoxelType type, const ValueRange& extremes, int side)
{
  VolumeSummary summary;
  summary.smallest = extremes.lower;
  summary.largest = extremes.upper;
  summary.coarse.side = side;
  ByVoxelType(type,
    [&](auto voxel)
    {
      using Limits = std::numeric_limits<decltype(voxel)>;
      const glm::ivec3 cells = glm::max(VoxelCountOf(level) - 1, 1);
      summary.ranges = Limits::is_integer
        ? BrickRanges(cells, double(Limits::lowest()), double(Limits::max()), true, side)
        : BrickRanges(cells, extremes.lower, extremes.upper, false, side);
      summary.counts.resize(Limits::is_integer ? std::size_t(1) << (8 * sizeof(voxel)) : 0);
      const glm::ivec3 means = VoxelCountOf(level) / side;
      if (std::min({ means.x, means.y, means.z }) > 1)
      {
        summary.coarse.voxelCount = means;
        summary.coarse.voxels.resize(
          sizeof(voxel) * std::size_t(means.x) * means.y * std::size_t(means.z));
      }
    });
  return summary;
}

bool AreZero(const BrickRanges& ranges, const BrickSource::Box& box)
{
  const glm::ivec3 count = ranges.BrickCount();
  // The last brick has the last voxel of its far faces too.
  const auto brickOf = [&](const std::array<std::int64_t, 3>& voxel)
  { return glm::min(glm::ivec3(voxel[0], voxel[1], voxel[2]) / ranges.Side(), count - 1); };
  const glm::ivec3 first = brickOf(box.lower);
  const glm::ivec3 last = brickOf({ box.upper[0] - 1, box.upper[1] - 1, box.upper[2] - 1 });
  const double zero = -ranges.FirstValue() / ranges.ValuePerStep();
  for (int row = 0; row < (last.y - first.y + 1) * (last.z - first.z + 1); ++row)
  {
    const int y = first.y + row % (last.y - first.y + 1);
    const int z = first.z + row / (last.y - first.y + 1);
    const std::size_t begin = (std::size_t(z) * count.y + y) * count.x;
    for (std::size_t brick = begin + first.x; brick <= begin + last.x; ++brick)
    {
      const BrickRanges::Steps steps = ranges[brick];
      if (steps.smallest != zero || steps.largest != zero)
      {
        return false;
      }
    }
  }
  return true;
}

std::uint64_t BytesOfBricks(const BrickSource::Level& level, VoxelType type, int side)
{
  double bricks = 1.0; // the product of the numbers that a forged file states may be beyond 2^64
  for (const std::int64_t voxels : level.dimensions)
  {
    bricks *= double((std::max<std::int64_t>(voxels - 1, 1) - 1) / side + 1);
  }
  constexpr std::uint64_t BytesOfField = 3; // with the distances and what is visible
  const std::uint64_t bytesOfMean = ByVoxelType(type, [](auto voxel) { return sizeof(voxel); });
  const std::uint64_t bytesOfRange = bytesOfMean == 1 ? 2 : 4;
  constexpr double MostBytes = 9e18;
  return std::uint64_t(
    std::min(bricks * double(BytesOfField + bytesOfRange + bytesOfMean), MostBytes));
}

int SideOfBricks(const BrickSource::Level& level, VoxelType type, std::uint64_t mostBytes)
{
  constexpr int Largest = 32; // a sum of so many voxels of 16 bits has 31 bits
  int side = BrickRanges::CellsPerSide;
  while (side < Largest && BytesOfBricks(level, type, side) > mostBytes)
  {
    side *= 2;
  }
  return side;
}

VolumeSummary SummaryOf(const BrickSource& source, const SummaryOptions& options,
  const std::function<void(double)>& report)
{
  return ByVoxelType(
    source.Type(), [&](auto voxel) { return SummaryOf<decltype(voxel)>(source, options, report); });
}

}
