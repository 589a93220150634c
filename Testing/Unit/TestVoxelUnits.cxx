#include "Core/Blocks/VoxelUnits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <random>
#include <set>
#include <vector>

using namespace varimarch;

namespace
{

constexpr std::size_t PageBytes = 64;

/// Levels and units of any form whose slices have at least two pages.
class AnyUnits
{
public:
  explicit AnyUnits(unsigned seed)
  {
    std::mt19937 random(seed);
    const auto upTo = [&](std::int64_t most)
    { return std::uniform_int_distribution<std::int64_t>(1, most)(random); };
    do
    {
      this->voxelBytes = std::size_t(1) << (upTo(3) - 1);
      this->level = { { upTo(90), upTo(30), upTo(12) }, { upTo(20), upTo(12), upTo(6) }, {} };
    } while (!VoxelUnits::AreIn(this->level, this->voxelBytes, PageBytes));
    this->wantedBytes = double(upTo(20000));
  }

  VoxelUnits Units() const
  {
    return { this->level, this->voxelBytes, PageBytes, this->wantedBytes };
  }

  std::uint64_t Bytes() const
  {
    const auto& size = this->level.dimensions;
    return std::uint64_t(size[0] * size[1] * size[2]) * this->voxelBytes;
  }

  BrickSource::Level level;
  std::size_t voxelBytes;
  double wantedBytes;
};

TEST(VoxelUnits, HaveEachPageOnce)
{
  for (unsigned seed = 0; seed < 2000; ++seed)
  {
    const AnyUnits any(seed);
    const VoxelUnits units = any.Units();
    std::vector<int> owners((any.Bytes() + PageBytes - 1) / PageBytes, 0);
    for (std::size_t unit = 0; unit < units.Count(); ++unit)
    {
      const BrickSource::Box box = units.BoxOf(unit);
      for (std::int64_t slice = box.lower[2]; slice < box.upper[2]; ++slice)
      {
        const VoxelUnits::Run run = units.RunOf(unit, slice);
        ASSERT_LT(run.begin, run.end) << seed;
        for (std::uint64_t byte = run.begin; byte < run.end; byte += PageBytes)
        {
          ASSERT_EQ(units.UnitAt(byte), unit) << seed;
          ++owners.at(byte / PageBytes);
        }
      }
    }
    ASSERT_EQ(std::count(owners.begin(), owners.end(), 1), std::ptrdiff_t(owners.size())) << seed;
  }
}

/// The bytes of the volume that a box of rows begins and ends with in a slice.
VoxelUnits::Run BytesOf(const VoxelUnits& units, const BrickSource::Box& box, std::int64_t slice)
{
  return { units.ByteOfRow(box.lower[1], slice), units.ByteOfRow(box.upper[1], slice) };
}

TEST(VoxelUnits, HaveTheRowsThatTheirPagesReachInto)
{
  for (unsigned seed = 0; seed < 2000; ++seed)
  {
    const AnyUnits any(seed);
    const VoxelUnits units = any.Units();
    for (std::size_t unit = 0; unit < units.Count(); ++unit)
    {
      const BrickSource::Box box = units.BoxOf(unit);
      const auto behind = units.BoxBehind(unit);
      for (std::int64_t slice = box.lower[2]; slice < box.upper[2]; ++slice)
      {
        const VoxelUnits::Run pages = units.RunOf(unit, slice);
        const VoxelUnits::Run own = BytesOf(units, box, slice);
        ASSERT_GE(pages.begin, own.begin) << seed;
        const std::int64_t sliceBehind =
          behind ? behind->lower[2] + slice - box.lower[2] : any.level.dimensions[2];
        std::uint64_t end = own.end;
        if (behind && sliceBehind < behind->upper[2])
        {
          const VoxelUnits::Run next = BytesOf(units, *behind, sliceBehind);
          ASSERT_EQ(next.begin, own.end) << seed;
          end = next.end;
        }
        ASSERT_GE(end, std::min(pages.end, any.Bytes())) << seed;
      }
    }
  }
}

/// Some blocks of a volume, most of them coarse.
BlockLevels SomeBlocks(const BrickSource::Level& level, std::mt19937& random)
{
  const int side = std::uniform_int_distribution<int>(1, 20)(random);
  BlockLevels blocks;
  blocks.side = side;
  for (int axis = 0; axis < 3; ++axis)
  {
    blocks.count[axis] = std::max(1, (int(level.dimensions[std::size_t(axis)]) - 2) / side + 1);
  }
  const auto all = std::size_t(blocks.count.x) * blocks.count.y * blocks.count.z;
  std::generate_n(std::back_inserter(blocks.ofBlocks), all,
    [&] { return random() % 8 == 0 ? BlockLevel::Voxels : BlockLevel::Coarse; });
  return blocks;
}

TEST(VoxelUnits, AreCountedWhereTheyHaveVoxelsOfBlocks)
{
  for (unsigned seed = 0; seed < 500; ++seed)
  {
    const AnyUnits any(seed);
    const VoxelUnits units = any.Units();
    std::mt19937 random(seed);
    const BlockLevels blocks = SomeBlocks(any.level, random);
    std::set<std::size_t> read;
    for (std::size_t unit = 0; unit < units.Count(); ++unit)
    {
      const BrickSource::Box box = units.BoxOf(unit);
      const auto areBeside = [&](std::int64_t block, std::size_t axis)
      {
        const std::int64_t first = block * blocks.side; // its last voxels are the first of the next
        return first < box.upper[axis] && first + blocks.side >= box.lower[axis];
      };
      for (std::size_t i = 0; i < blocks.ofBlocks.size(); ++i)
      {
        const auto row = std::int64_t(i) / blocks.count.x;
        if (blocks.ofBlocks[i] == BlockLevel::Voxels && areBeside(row % blocks.count.y, 1) &&
          areBeside(row / blocks.count.y, 2))
        {
          read.insert(unit);
        }
      }
    }
    ASSERT_EQ(units.MostBytesFor(blocks), units.MostBytes() * read.size()) << seed;
  }
}

}
