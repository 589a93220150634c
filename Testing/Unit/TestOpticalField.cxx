#include "Core/Fields/OpticalField.h"

#include "Core/Fields/BrickRanges.h"
#include "Core/Fields/VisibleBricks.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace varimarch;

namespace
{

struct RandomScene
{
  glm::ivec3 dimensions;
  std::vector<std::uint8_t> voxels;
  OpticalTable table;

  ScalarGrid<std::uint8_t> Grid() const { return { this->voxels.data(), this->dimensions }; }
};

/// Smooth blobs in an empty volume, with a plateau; the transfer function has visible and invisible
/// parts.
RandomScene SceneOf(unsigned seed)
{
  std::mt19937 random(seed);
  const auto number = [&](double from, double to)
  { return std::uniform_real_distribution<double>(from, to)(random); };
  RandomScene scene;
  scene.dimensions = { 23 + int(seed % 7), 30, 41 };
  const glm::dvec3 center(number(5, 20), number(5, 25), number(5, 35));
  const double radius = number(9, 14);
  for (int z = 0; z < scene.dimensions.z; ++z)
  {
    for (int y = 0; y < scene.dimensions.y; ++y)
    {
      for (int x = 0; x < scene.dimensions.x; ++x)
      {
        const double distance = glm::length(glm::dvec3(x, y, z) - center);
        const double value = 255.0 * std::clamp(4.0 * (1.0 - distance / radius), 0.0, 1.0);
        scene.voxels.push_back(std::uint8_t(value));
      }
    }
  }
  const double first = number(10, 100);
  scene.table =
    BuildOpticalTable(TransferFunction({ { 0.0, { 1.0, 0.0, 0.0 } }, { 255.0, { 0.0, 1.0, 0.5 } } },
                        { { first, 0.0 }, { first + 20.0, number(0.01, 0.5) }, { 180.0, 0.0 },
                          { 200.0, 0.0 }, { 240.0, 0.1 } },
                        1.0),
      0.0, 255.0);
  return scene;
}

glm::vec4 Look(const OpticalTable& table, double value)
{
  const double position =
    std::clamp((value - table.firstValue) / (table.lastValue - table.firstValue), 0.0, 1.0) *
    double(table.entries.size() - 1);
  const auto below = std::min(std::size_t(position), table.entries.size() - 2);
  return glm::mix(table.entries[below], table.entries[below + 1], float(position - below));
}

glm::ivec3 BrickAt(const OpticalField& field, glm::dvec3 position)
{
  return glm::clamp(glm::ivec3(glm::floor(position / double(BrickRanges::CellsPerSide))),
    glm::ivec3(0), field.brickCount - 1);
}

std::uint8_t ByteAt(const OpticalField& field, glm::ivec3 brick)
{
  return field
    .bricks[(std::size_t(brick.z) * field.brickCount.y + brick.y) * field.brickCount.x + brick.x];
}

OpticalField FieldOf(const RandomScene& scene, const OpticalTolerance& tolerance)
{
  return BuildOpticalField(BuildBrickRanges(scene.Grid(), 0.0, 255.0), scene.table, tolerance);
}

}

TEST(OpticalField, FarValuesHideNothing)
{
  const glm::ivec3 dimensions(9, 5, 5);
  std::vector<double> voxels(std::size_t(9) * 5 * 5, 0.0);
  voxels[2] = 100.0; // in the first brick
  voxels[8] = -1e20; // in the second one
  const BrickRanges ranges =
    BuildBrickRanges(ScalarGrid<double>(voxels.data(), dimensions), -1000.0, 1000.0);
  const OpticalTable table = BuildOpticalTable(
    TransferFunction({}, { { 60.0, 0.0 }, { 255.0, 0.5 } }, 1.0), -1000.0, 1000.0);
  const OpticalField field =
    BuildOpticalField(ranges, table, OpticalTolerance::ForError(1.0 / 64.0, 10.0));
  EXPECT_EQ(ByteAt(field, { 0, 0, 0 }), OpticalField::Structured);
  EXPECT_EQ(ByteAt(field, { 1, 0, 0 }), OpticalField::Invisible);
}

class OpticalFieldOf : public testing::TestWithParam<unsigned>
{
};

TEST_P(OpticalFieldOf, ABlockThatMayBeLeftIsInvisibleEverywhere)
{
  const RandomScene scene = SceneOf(GetParam());
  const auto grid = scene.Grid();
  const OpticalField field = FieldOf(scene, OpticalTolerance::ForError(1.0 / 64.0, 60.0));
  std::mt19937 random(GetParam());
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const auto point = [&](glm::dvec3 lower, glm::dvec3 upper)
  { return lower + (upper - lower) * glm::dvec3(unit(random), unit(random), unit(random)); };
  const glm::dvec3 last(scene.dimensions - 1);
  int left = 0;
  for (int i = 0; i < 3000; ++i)
  {
    const glm::ivec3 brick = BrickAt(field, point(glm::dvec3(0.0), last));
    const int byte = ByteAt(field, brick);
    if (byte < OpticalField::Invisible)
    {
      continue;
    }
    ++left;
    const int radius = byte - OpticalField::Invisible;
    const glm::dvec3 lower =
      glm::max(glm::dvec3(BrickRanges::CellsPerSide * (brick - radius)), 0.0);
    const glm::dvec3 upper =
      glm::min(glm::dvec3(BrickRanges::CellsPerSide * (brick + radius + 1)), last);
    EXPECT_EQ(Look(scene.table, grid.Value(point(lower, upper))).a, 0.0f);
  }
  EXPECT_GT(left, 100) << "hardly any block is skippable";
}

TEST_P(OpticalFieldOf, NothingIsVisibleOutsideTheVisibleBox)
{
  const RandomScene scene = SceneOf(GetParam());
  const auto grid = scene.Grid();
  const OpticalField field = FieldOf(scene, OpticalTolerance::Nothing(60.0));
  const glm::dvec3 last(scene.dimensions - 1);
  const Box box = VisibleBricks(field).Bounds({ glm::dvec3(0.0), last });
  std::mt19937 random(GetParam());
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  int outside = 0;
  for (int i = 0; i < 3000; ++i)
  {
    const glm::dvec3 position = last * glm::dvec3(unit(random), unit(random), unit(random));
    if (glm::clamp(position, box.lower, box.upper) != position)
    {
      ++outside;
      EXPECT_EQ(Look(scene.table, grid.Value(position)).a, 0.0f);
    }
  }
  EXPECT_GT(outside, 0) << "the box covers the whole volume";
}

TEST(OpticalField, TheVisibleBoxOfAnInvisibleVolumeIsEmpty)
{
  RandomScene scene = SceneOf(1);
  scene.table = BuildOpticalTable(TransferFunction({}, { { 0.0, 0.0 } }, 1.0), 0.0, 255.0);
  const VisibleBricks visible(FieldOf(scene, OpticalTolerance::Nothing(60.0)));
  const Box box = visible.Bounds({ glm::dvec3(0.0), glm::dvec3(40.0) });
  EXPECT_GE(box.lower.x, box.upper.x);
}

TEST(OpticalField, SkippableBricksAreAllButTheStructuredOnesOfABox)
{
  constexpr std::uint8_t Structured = OpticalField::Structured;
  const OpticalField field{ { 2, 2, 1 },
    { Structured, OpticalField::Homogeneous, Structured, OpticalField::Invisible + 3 } };
  EXPECT_DOUBLE_EQ(field.SkippablePart({ glm::dvec3(0.0), { 8.0, 8.0, 4.0 } }), 0.5);
  EXPECT_DOUBLE_EQ(field.SkippablePart({ glm::dvec3(0.0), { 4.0, 8.0, 4.0 } }), 0.0);
  EXPECT_DOUBLE_EQ(field.SkippablePart({ { 4.0, 0.0, 0.0 }, { 8.0, 8.0, 4.0 } }), 1.0);
}

TEST_P(OpticalFieldOf, AHomogeneousBrickKeepsItsTolerance)
{
  const RandomScene scene = SceneOf(GetParam());
  const auto grid = scene.Grid();
  const OpticalTolerance tolerance{ 0.2, 0.05, 0.3, 60.0 };
  const OpticalField field = FieldOf(scene, tolerance);
  std::mt19937 random(GetParam());
  std::uniform_real_distribution<double> inside(0.0, double(BrickRanges::CellsPerSide));
  int homogeneous = 0;
  for (int i = 0; i < int(field.bricks.size()); ++i)
  {
    if (field.bricks[i] != OpticalField::Homogeneous)
    {
      continue;
    }
    ++homogeneous;
    const glm::ivec3 brick(i % field.brickCount.x, i / field.brickCount.x % field.brickCount.y,
      i / field.brickCount.x / field.brickCount.y);
    glm::vec4 smallest(1e30f);
    glm::vec4 largest(-1e30f);
    for (int sample = 0; sample < 50; ++sample)
    {
      const glm::dvec3 position = glm::min(glm::dvec3(BrickRanges::CellsPerSide * brick) +
          glm::dvec3(inside(random), inside(random), inside(random)),
        glm::dvec3(scene.dimensions - 1));
      const glm::vec4 look = Look(scene.table, grid.Value(position));
      smallest = glm::min(smallest, look);
      largest = glm::max(largest, look);
    }
    const double allowed = std::max(
      tolerance.relativeExtinction * smallest.a, tolerance.opticalDepth / tolerance.longestRayMm);
    EXPECT_LE(largest.a - smallest.a, allowed + 1e-6);
    EXPECT_LE(largest.r - smallest.r, tolerance.color + 1e-6);
  }
  EXPECT_GT(homogeneous, 0);
}

TEST_P(OpticalFieldOf, WithoutToleranceNoBrickIsHomogeneous)
{
  const RandomScene scene = SceneOf(GetParam());
  const OpticalField field = FieldOf(scene, OpticalTolerance::Nothing(60.0));
  for (const std::uint8_t byte : field.bricks)
  {
    EXPECT_NE(byte, OpticalField::Homogeneous);
  }
}

TEST(BrickRanges, AreThoseOfAllVoxelsThatABrickReads)
{
  // The same values as 8 and 16 bits; the latter are scaled beyond the range of 8 bits.
  const RandomScene scene = SceneOf(3);
  std::vector<std::uint16_t> spread(scene.voxels.begin(), scene.voxels.end());
  for (std::uint16_t& voxel : spread)
  {
    voxel = std::uint16_t(voxel * 100);
  }
  const ScalarGrid<std::uint16_t> wideGrid(spread.data(), scene.dimensions);
  const BrickRanges narrow = BuildBrickRanges(scene.Grid(), 0.0, 255.0);
  const BrickRanges wide = BuildBrickRanges(wideGrid, 0.0, 25500.0);
  const glm::ivec3 count = narrow.BrickCount();
  for (int i = 0; i < count.x * count.y * count.z; ++i)
  {
    const glm::ivec3 first = BrickRanges::CellsPerSide *
      glm::ivec3(i % count.x, i / count.x % count.y, i / count.x / count.y);
    int smallest = 255;
    int largest = 0;
    for (int voxel = 0; voxel < 125; ++voxel)
    {
      const glm::ivec3 position =
        glm::min(first + glm::ivec3(voxel % 5, voxel / 5 % 5, voxel / 25), scene.dimensions - 1);
      smallest = std::min(smallest, int(scene.Grid().Voxel(position)));
      largest = std::max(largest, int(scene.Grid().Voxel(position)));
    }
    EXPECT_EQ(narrow[i].smallest, smallest);
    EXPECT_EQ(narrow[i].largest, largest);
    EXPECT_EQ(wide[i].smallest, 100 * smallest);
    EXPECT_EQ(wide[i].largest, 100 * largest);
  }
}

TEST(BrickRanges, AndTheFieldTakeAtMostATwentiethOfAnEightBitVolume)
{
  const glm::ivec3 dimensions(128);
  const std::vector<std::uint8_t> voxels(128 * 128 * 128, 7);
  const BrickRanges ranges =
    BuildBrickRanges(ScalarGrid<std::uint8_t>(voxels.data(), dimensions), 0.0, 255.0);
  const OpticalTable table = BuildOpticalTable(TransferFunction({}, {}, 1.0), 0.0, 255.0);
  const OpticalField field =
    BuildOpticalField(ranges, table, OpticalTolerance::ForError(0.01, 100.0));
  EXPECT_LE(ranges.Bytes() + field.bricks.size(), voxels.size() / 20);
}

INSTANTIATE_TEST_SUITE_P(RandomScenes, OpticalFieldOf, testing::Range(1u, 9u));

// Every visible brick lies in the hull, or has bricks of the hull on all sides.
TEST_P(OpticalFieldOf, TheHullIsWhereTheVisibleBlocksEnd)
{
  const OpticalField field = FieldOf(SceneOf(GetParam()), OpticalTolerance::Nothing(60.0));
  constexpr int BlockSide = 2;
  const std::vector<glm::ivec3> hull = VisibleHull(field, BlockSide);
  const glm::ivec3 blocks = (field.brickCount + BlockSide - 1) / BlockSide;
  const auto holds = [&](glm::ivec3 block)
  {
    bool visible = false;
    for (int i = 0; i < BlockSide * BlockSide * BlockSide; ++i)
    {
      const glm::ivec3 brick = BlockSide * block + glm::ivec3(i % 2, i / 2 % 2, i / 4);
      const bool exists = glm::all(glm::greaterThanEqual(brick, glm::ivec3(0))) &&
        glm::all(glm::lessThan(brick, field.brickCount));
      visible = visible || (exists && ByteAt(field, brick) < OpticalField::Invisible);
    }
    return visible;
  };
  std::size_t expected = 0;
  for (int i = 0; i < blocks.x * blocks.y * blocks.z; ++i)
  {
    const glm::ivec3 block(i % blocks.x, i / blocks.x % blocks.y, i / blocks.x / blocks.y);
    bool isInside = true;
    for (int axis = 0; axis < 3; ++axis)
    {
      glm::ivec3 step(0);
      step[axis] = 1;
      isInside = isInside && holds(block - step) && holds(block + step);
    }
    const bool inHull = std::find(hull.begin(), hull.end(), block) != hull.end();
    EXPECT_EQ(inHull, holds(block) && !isInside);
    expected += holds(block) && !isInside ? 1 : 0;
  }
  EXPECT_EQ(hull.size(), expected);
  EXPECT_GT(expected, 0u);
}
