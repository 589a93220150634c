#include "Core/Fields/VolumeSummary.h"

#include "Unit/MemorySource.h"

#include <glm/glm.hpp>
#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstring>
#include <limits>
#include <mutex>
#include <random>
#include <stdexcept>
#include <thread>

using namespace varimarch;

namespace
{

constexpr glm::ivec2 SliceDimensions = glm::ivec2(13, 9);
constexpr int UsualSlices = 70;
constexpr std::uint64_t EnoughForASlab = 1 << 20;

template <class Scalar>
std::vector<Scalar> Noise(double lower, double upper, int slices = UsualSlices)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> values(lower, upper);
  std::vector<Scalar> voxels(std::size_t(SliceDimensions.x * SliceDimensions.y * slices));
  std::generate(voxels.begin(), voxels.end(), [&] { return Scalar(values(random)); });
  return voxels;
}

template <class Scalar>
void ExpectRangesOfTheWhole(const VolumeSummary& summary, const MemorySource<Scalar>& source)
{
  const BrickRanges& found = summary.ranges;
  const BrickRanges expected = BuildBrickRanges(source.Grid(), found.FirstValue(),
    found.FirstValue() + found.LastStep() * found.ValuePerStep());
  ASSERT_EQ(found.BrickCount(), expected.BrickCount());
  const glm::ivec3 count = expected.BrickCount();
  for (std::size_t brick = 0; brick < std::size_t(count.x * count.y * count.z); ++brick)
  {
    EXPECT_EQ(found[brick].smallest, expected[brick].smallest) << brick;
    EXPECT_EQ(found[brick].largest, expected[brick].largest) << brick;
  }
}

TEST(VolumeSummary, OfSlabsIsThatOfTheWhole)
{
  const MemorySource<std::int16_t> source(
    VoxelType::Int16, Noise<std::int16_t>(-300.0, 900.0), SliceDimensions);
  const VolumeSummary summary = SummaryOf(source, { EnoughForASlab }, [](double) {});
  ExpectRangesOfTheWhole(summary, source);
  const std::vector<std::int16_t> voxels = Noise<std::int16_t>(-300.0, 900.0);
  EXPECT_EQ(summary.smallest, *std::min_element(voxels.begin(), voxels.end()));
  EXPECT_EQ(summary.largest, *std::max_element(voxels.begin(), voxels.end()));
  EXPECT_EQ(summary.counts[32768 + 17], std::count(voxels.begin(), voxels.end(), 17));
}

// A slab has 16 slices: the last one may have no cells, and a volume may be a single slice.
TEST(VolumeSummary, OfAnyNumberOfSlicesHasAllVoxels)
{
  for (const int slices : { 1, 16, 17, 20, 65 })
  {
    const std::vector<std::uint8_t> voxels = Noise<std::uint8_t>(0.0, 255.0, slices);
    const MemorySource<std::uint8_t> source(VoxelType::UInt8, voxels, SliceDimensions);
    const VolumeSummary summary = SummaryOf(source, { EnoughForASlab }, [](double) {});
    ExpectRangesOfTheWhole(summary, source);
    for (int value = 0; value < 256; ++value)
    {
      EXPECT_EQ(summary.counts[std::size_t(value)], std::count(voxels.begin(), voxels.end(), value))
        << slices << " slices";
    }
  }
}

TEST(VolumeSummary, HasTheMeansOfCubes)
{
  const MemorySource<std::int16_t> source(
    VoxelType::Int16, Noise<std::int16_t>(-300.0, 900.0), SliceDimensions);
  const VolumeSummary summary = SummaryOf(source, { EnoughForASlab }, [](double) {});
  ASSERT_EQ(summary.coarse.voxelCount, glm::ivec3(3, 2, 17));
  const auto* const means = reinterpret_cast<const std::int16_t*>(summary.coarse.voxels.data());
  const glm::ivec3 cube(2, 1, 16);
  double sum = 0.0;
  for (int i = 0; i < 64; ++i)
  {
    sum += source.Grid().Voxel(4 * cube + glm::ivec3(i % 4, i / 4 % 4, i / 16));
  }
  EXPECT_NEAR(means[(16 * 2 + 1) * 3 + 2], sum / 64.0, 0.5);
}

TEST(VolumeSummary, TellsValuesThatAreNotFinite)
{
  std::vector<float> voxels = Noise<float>(-1.0, 2.0);
  EXPECT_TRUE(SummaryOf(MemorySource<float>(VoxelType::Float32, voxels, SliceDimensions),
    { EnoughForASlab },
    [](double) {
    }).areFinite);
  voxels[1000] = std::numeric_limits<float>::infinity();
  const MemorySource<float> source(VoxelType::Float32, voxels, SliceDimensions);
  const VolumeSummary summary = SummaryOf(source, { EnoughForASlab }, [](double) {});
  EXPECT_FALSE(summary.areFinite);
  EXPECT_LT(summary.largest, 2.0);
  ExpectRangesOfTheWhole(summary, source);
}

TEST(VolumeSummary, StopsWhereItsObserverThrows)
{
  const MemorySource<std::uint8_t> source(
    VoxelType::UInt8, Noise<std::uint8_t>(0.0, 255.0), SliceDimensions);
  const auto stop = [](double) { throw std::logic_error("enough"); };
  EXPECT_THROW(SummaryOf(source, { EnoughForASlab }, stop), std::logic_error);
}

/// Voxels that count how many are read at the same time.
class CountingSource : public MemorySource<std::uint8_t>
{
public:
  CountingSource()
    : MemorySource(VoxelType::UInt8, Noise<std::uint8_t>(0.0, 255.0), SliceDimensions)
  {
  }

  void Read(int level, const Box& box, void* to) const override
  {
    const int now = ++this->reading;
    int most = this->most;
    while (now > most && !this->most.compare_exchange_weak(most, now))
    {
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    MemorySource::Read(level, box, to);
    --this->reading;
  }

  mutable std::atomic<int> reading = 0;
  mutable std::atomic<int> most = 0;
};

TEST(VolumeSummary, IsReadInOneSlabAtATimeWhereMemoryIsShort)
{
  const CountingSource source;
  SummaryOf(source, { 1 }, [](double) {});
  EXPECT_EQ(source.most, 1);
}

/// Voxels of which only a box is stored; the others are 7.
template <class Scalar>
class StoredBox : public MemorySource<Scalar>
{
public:
  StoredBox(VoxelType type, std::vector<Scalar> voxels, const BrickSource::Box& stored)
    : MemorySource<Scalar>(type, std::move(voxels), SliceDimensions)
    , stored(stored)
  {
  }

  BrickSource::Box Occupied(const BrickSource::Box& box) const override
  {
    BrickSource::Box common = box;
    bool isEmpty = false;
    for (int axis = 0; axis < 3; ++axis)
    {
      common.lower[axis] = std::max(box.lower[axis], this->stored.lower[axis]);
      common.upper[axis] = std::min(box.upper[axis], this->stored.upper[axis]);
      isEmpty = isEmpty || common.lower[axis] >= common.upper[axis];
    }
    return isEmpty ? BrickSource::Box{ box.lower, box.lower } : common;
  }

  double Fill() const override { return 7.0; }

private:
  BrickSource::Box stored;
};

template <class Scalar>
void ExpectSummaryOfStoredBox(VoxelType type, const BrickSource::Box& stored)
{
  std::vector<Scalar> voxels = Noise<Scalar>(10.0, 90.0);
  for (std::size_t i = 0; i < voxels.size(); ++i)
  {
    const std::array<std::int64_t, 3> place = { std::int64_t(i) % SliceDimensions.x,
      std::int64_t(i) / SliceDimensions.x % SliceDimensions.y,
      std::int64_t(i) / (SliceDimensions.x * SliceDimensions.y) };
    bool isStored = true;
    for (int axis = 0; axis < 3; ++axis)
    {
      isStored = isStored && place[axis] >= stored.lower[axis] && place[axis] < stored.upper[axis];
    }
    voxels[i] = isStored ? voxels[i] : Scalar(7);
  }
  const auto nothing = [](double) {};
  const VolumeSummary whole =
    SummaryOf(MemorySource<Scalar>(type, voxels, SliceDimensions), { EnoughForASlab }, nothing);
  // The second has slabs of a few chunks.
  const auto threads = std::uint64_t(tbb::this_task_arena::max_concurrency());
  for (const std::uint64_t mostBytes : { EnoughForASlab, threads * 1000 * sizeof(Scalar) })
  {
    const VolumeSummary sparse =
      SummaryOf(StoredBox<Scalar>(type, voxels, stored), { mostBytes }, nothing);
    EXPECT_EQ(sparse.smallest, whole.smallest);
    EXPECT_EQ(sparse.largest, whole.largest);
    EXPECT_EQ(sparse.counts, whole.counts);
    EXPECT_EQ(sparse.coarse.voxels, whole.coarse.voxels);
    ASSERT_EQ(sparse.ranges.Bytes(), whole.ranges.Bytes());
    EXPECT_EQ(std::memcmp(sparse.ranges.Memory(), whole.ranges.Memory(), whole.ranges.Bytes()), 0);
  }
}

TEST(VolumeSummary, OfWhatIsStoredIsThatOfTheWhole)
{
  // Boxes that end at, before and behind the border of a brick, and at that of the volume.
  for (const std::int64_t lower : { 0, 3, 4, 5 })
  {
    for (const std::int64_t upper : { 7, 8, 9 })
    {
      const BrickSource::Box stored = { { lower, lower, 15 + lower }, { upper + 4, upper, 40 } };
      ExpectSummaryOfStoredBox<std::uint8_t>(VoxelType::UInt8, stored);
      ExpectSummaryOfStoredBox<std::int16_t>(VoxelType::Int16, stored);
      ExpectSummaryOfStoredBox<float>(VoxelType::Float32, stored);
    }
  }
}

std::vector<std::uint8_t> Scattered(const glm::ivec3& size)
{
  std::vector<std::uint8_t> voxels;
  for (int i = 0; i < size.x * size.y * size.z; ++i)
  {
    voxels.push_back(std::uint8_t(i * 7919 % 251));
  }
  return voxels;
}

TEST(VolumeSummary, HasLargerBricksAndCubesWhereTheyAreWanted)
{
  constexpr int Side = 8;
  const glm::ivec3 size(20, 18, 40);
  const MemorySource<std::uint8_t> source(VoxelType::UInt8, Scattered(size), glm::ivec2(size));
  const VolumeSummary summary = SummaryOf(source, { EnoughForASlab, Side }, [](double) {});
  const BrickRanges expected = BuildBrickRanges(source.Grid(), 0.0, 255.0, 0, Side);
  ASSERT_EQ(summary.ranges.BrickCount(), (size - 1 + Side - 1) / Side);
  ASSERT_EQ(summary.ranges.Bytes(), expected.Bytes());
  EXPECT_EQ(std::memcmp(summary.ranges.Memory(), expected.Memory(), expected.Bytes()), 0);
  ASSERT_EQ(summary.coarse.voxelCount, size / Side);
  double sum = 0.0;
  for (int i = 0; i < Side * Side * Side; ++i)
  {
    sum += source.Grid().Voxel({ i % Side, i / Side % Side, i / Side / Side });
  }
  EXPECT_EQ(summary.coarse.voxels.front(), std::lround(sum / (Side * Side * Side)));
}

/// Voxels in chunks of 8 that remember which boxes were read.
class WatchedSource : public MemorySource<std::uint8_t>
{
public:
  using MemorySource::MemorySource;

  void Read(int level, const Box& box, void* to) const override
  {
    const std::lock_guard<std::mutex> lock(this->mutex);
    this->boxes.push_back(box);
    MemorySource::Read(level, box, to);
  }

  mutable std::mutex mutex;
  mutable std::vector<Box> boxes;
};

// Slabs that overlap, or that are thinner than chunks, would have chunks decoded again and again.
TEST(VolumeSummary, ReadsEachChunkOnce)
{
  const glm::ivec3 size(20, 90, 48);
  const WatchedSource source(VoxelType::UInt8, Scattered(size), glm::ivec2(size));
  const auto nothing = [](double) {};
  const VolumeSummary whole = SummaryOf(source, { 1 << 22 }, nothing);
  EXPECT_EQ(source.boxes.size(), 1u);
  source.boxes.clear();
  const auto threads = std::uint64_t(tbb::this_task_arena::max_concurrency());
  constexpr std::uint64_t TwoChunks = 2 * 8 * 8 * 8;
  const VolumeSummary boxes = SummaryOf(source, { threads * TwoChunks }, nothing);
  EXPECT_GE(source.boxes.size(), 100u);
  std::int64_t read = 0;
  for (const BrickSource::Box& box : source.boxes)
  {
    std::int64_t voxels = 1;
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_EQ(box.lower[axis] % 8, 0);
      EXPECT_TRUE(box.upper[axis] % 8 == 0 || box.upper[axis] == size[axis]);
      voxels *= box.upper[axis] - box.lower[axis];
    }
    read += voxels;
  }
  EXPECT_EQ(read, std::int64_t(size.x) * size.y * size.z);
  EXPECT_EQ(boxes.counts, whole.counts);
  EXPECT_EQ(boxes.coarse.voxels, whole.coarse.voxels);
  EXPECT_EQ(std::memcmp(boxes.ranges.Memory(), whole.ranges.Memory(), whole.ranges.Bytes()), 0);
}

TEST(VolumeSummary, TellsWhichBoxesAreZero)
{
  std::mt19937 random(7);
  const glm::ivec3 size(SliceDimensions, 20);
  for (int trial = 0; trial < 300; ++trial)
  {
    const auto place = [&]
    { return glm::ivec3(glm::uvec3(random(), random(), random()) % glm::uvec3(size)); };
    const glm::ivec3 voxel = place();
    std::vector<std::int16_t> voxels(std::size_t(size.x * size.y * size.z));
    voxels[std::size_t((voxel.z * size.y + voxel.y) * size.x + voxel.x)] = trial % 2 == 0 ? 1 : -1;
    const MemorySource<std::int16_t> source(VoxelType::Int16, std::move(voxels), SliceDimensions);
    const VolumeSummary summary = SummaryOf(source, { EnoughForASlab }, [](double) {});
    const glm::ivec3 one = place();
    const glm::ivec3 other = place();
    const glm::ivec3 lower = glm::min(one, other);
    const glm::ivec3 upper = glm::max(one, other) + 1;
    const bool isFound =
      !AreZero(summary.ranges, { { lower.x, lower.y, lower.z }, { upper.x, upper.y, upper.z } });
    constexpr int Side = BrickRanges::CellsPerSide; // ranges are those of whole bricks
    const bool isInside =
      glm::all(glm::greaterThanEqual(voxel, lower)) && glm::all(glm::lessThan(voxel, upper));
    const bool isNear = glm::all(glm::greaterThanEqual(voxel, lower - Side)) &&
      glm::all(glm::lessThan(voxel, upper + Side));
    EXPECT_TRUE(isFound || !isInside) << trial;
    EXPECT_TRUE(isNear || !isFound) << trial;
  }
}

}
