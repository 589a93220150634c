#include "Core/Fields/BrickRows.h"

#include "Core/Fields/BrickRanges.h"
#include "Core/Geometry/ScalarGrid.h"

#include <glm/common.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

using namespace varimarch;

namespace
{

constexpr int Side = BrickRanges::CellsPerSide;

/// Boxes of rows in a mask of row 0.
std::vector<std::uint16_t> BoxesOfRows(glm::ivec3 size, std::mt19937& random)
{
  std::vector<std::uint16_t> rows(std::size_t(size.x) * size.y * size.z, 0);
  for (std::uint16_t row = 1; row < 6; ++row)
  {
    const glm::ivec3 begin(random() % size.x, random() % size.y, random() % size.z);
    const glm::ivec3 end = glm::min(begin + 1 + int(random() % 7), size);
    for (int z = begin.z; z < end.z; ++z)
    {
      for (int y = begin.y; y < end.y; ++y)
      {
        std::fill_n(
          rows.begin() + (std::ptrdiff_t(z) * size.y + y) * size.x + begin.x, end.x - begin.x, row);
      }
    }
  }
  return rows;
}

struct Bricks
{
  glm::ivec3 count;
  std::vector<std::set<std::uint16_t>> rows;
};

// The rows at close points of each brick, its corners included.
Bricks RowsAtPoints(
  const ScalarGrid<std::uint16_t>& mask, glm::ivec3 maskSize, glm::ivec3 voxelCount)
{
  constexpr int PerCell = 8;
  const glm::ivec3 cells = glm::max(voxelCount - 1, glm::ivec3(1));
  Bricks bricks{ (cells + Side - 1) / Side, {} };
  for (int i = 0; i < bricks.count.x * bricks.count.y * bricks.count.z; ++i)
  {
    const glm::ivec3 brick(
      i % bricks.count.x, i / bricks.count.x % bricks.count.y, i / bricks.count.x / bricks.count.y);
    std::set<std::uint16_t>& rows = bricks.rows.emplace_back();
    for (int z = 0; z <= PerCell * Side; ++z)
    {
      for (int y = 0; y <= PerCell * Side; ++y)
      {
        for (int x = 0; x <= PerCell * Side; ++x)
        {
          const glm::dvec3 position =
            glm::dvec3(Side * brick) + glm::dvec3(x, y, z) / double(PerCell);
          const glm::dvec3 inMask =
            (position + 0.5) * glm::dvec3(maskSize) / glm::dvec3(voxelCount);
          rows.insert(
            mask.Voxel(glm::clamp(glm::ivec3(glm::floor(inMask)), glm::ivec3(0), maskSize - 1)));
        }
      }
    }
  }
  return bricks;
}

}

TEST(BrickRows, AreThoseThatPointsOfABrickHave)
{
  const glm::ivec3 voxelCount(18, 13, 10);
  std::mt19937 random(3);
  for (const glm::ivec3 maskSize : { voxelCount, glm::ivec3(9, 13, 5), glm::ivec3(36, 26, 20) })
  {
    SCOPED_TRACE(testing::Message() << "mask of " << maskSize.x << " voxels along x");
    const std::vector<std::uint16_t> voxels = BoxesOfRows(maskSize, random);
    const BrickRows rows(voxels, maskSize, voxelCount);
    const Bricks expected =
      RowsAtPoints(ScalarGrid<std::uint16_t>(voxels.data(), maskSize), maskSize, voxelCount);
    ASSERT_TRUE(rows.AreKnown());
    for (std::size_t brick = 0; brick < expected.rows.size(); ++brick)
    {
      const std::vector<std::uint16_t>& set = rows.Sets()[rows.SetOf(brick)];
      EXPECT_EQ(std::set<std::uint16_t>(set.begin(), set.end()), expected.rows[brick]) << brick;
    }
  }
}

TEST(BrickRows, ShareTheirSets)
{
  const glm::ivec3 size(41);
  std::vector<std::uint16_t> voxels(std::size_t(size.x) * size.y * size.z, 2);
  voxels.front() = 7;
  const BrickRows rows(voxels, size, size);
  EXPECT_EQ(rows.Sets().size(), 2u);
  EXPECT_FALSE(BrickRows().AreKnown());
}
