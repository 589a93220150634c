#include "Core/Fields/FieldDirections.h"

#include "Core/Fields/OpticalField.h"

#include <glm/common.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/vector_relational.hpp>

#include <gtest/gtest.h>

#include <random>
#include <tuple>

using namespace varimarch;

namespace
{

const Box box{ glm::dvec3(0.0), glm::dvec3(60.0, 40.0, 30.0) };

glm::ivec3 DirectionsFrom(const glm::dmat4& projection, const glm::dvec3& eye)
{
  const glm::dvec3 middle = 0.5 * box.upper;
  const glm::dmat4 view = glm::lookAt(middle + eye, middle, glm::dvec3(0.1, 0.3, 1.0));
  return DirectionsOf(ComputePixelRays(projection * view, box));
}

const glm::dmat4 perspective = glm::perspective(glm::radians(30.0), 1.0, 50.0, 500.0);
const glm::dmat4 parallel = glm::ortho(-60.0, 60.0, -60.0, 60.0, 50.0, 500.0);

}

TEST(DirectionsOf, AreThoseThatAllRaysHave)
{
  EXPECT_EQ(DirectionsFrom(perspective, { 100.0, -90.0, 80.0 }), glm::ivec3(-1, 1, -1));
  EXPECT_EQ(DirectionsFrom(parallel, { -100.0, 90.0, 80.0 }), glm::ivec3(1, -1, -1));
}

TEST(DirectionsOf, AreNoneAlongAnAxisThatSomeRaysGoUpAndSomeDown)
{
  EXPECT_EQ(DirectionsFrom(perspective, { 0.0, -150.0, 0.0 }), glm::ivec3(0, 1, 0));
  EXPECT_EQ(DirectionsFrom(perspective, { 15.0, -150.0, 100.0 }), glm::ivec3(0, 1, -1));
  EXPECT_EQ(DirectionsFrom(parallel, { 0.0, -150.0, 0.0 }), glm::ivec3(0, 1, 0));
}

TEST(DirectionsOf, HoldForEveryRay)
{
  const glm::dmat4 view = glm::lookAt(
    glm::dvec3(150.0, -60.0, 20.0), glm::dvec3(30.0, 20.0, 15.0), glm::dvec3(0.0, 0.0, 1.0));
  const PixelRays rays = ComputePixelRays(perspective * view, box);
  const glm::ivec3 directions = DirectionsOf(rays);
  EXPECT_NE(directions, glm::ivec3(0));
  for (int i = 0; i < 441; ++i)
  {
    const glm::dvec3 ray = rays.At(i % 21 / 10.0 - 1.0, i / 21 / 10.0 - 1.0).direction;
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_GE(ray[axis] * directions[axis], 0.0);
    }
  }
}

TEST(FieldDirections, AreThoseOfTheFirstView)
{
  FieldDirections field;
  EXPECT_EQ(field.Next({ 1, -1, 0 }), glm::ivec3(1, -1, 0));
  EXPECT_EQ(field.Next({ 1, -1, 0 }), glm::ivec3(1, -1, 0));
}

TEST(FieldDirections, ServeTwoAlternatingViews)
{
  FieldDirections field;
  field.Next({ 1, -1, 1 });
  for (int picture = 0; picture < 40; ++picture)
  {
    EXPECT_EQ(field.Next({ -1, -1, 1 }), glm::ivec3(0, -1, 1));
    EXPECT_EQ(field.Next({ 1, -1, 1 }), glm::ivec3(0, -1, 1));
  }
}

TEST(FieldDirections, NarrowWhereAViewIsKept)
{
  FieldDirections field;
  field.Next({ 1, -1, 1 });
  EXPECT_EQ(field.Next({ -1, -1, 1 }), glm::ivec3(0, -1, 1));
  for (int picture = 0; picture < 20; ++picture)
  {
    field.Next({ -1, -1, 1 });
  }
  EXPECT_EQ(field.Next({ -1, -1, 1 }), glm::ivec3(-1, -1, 1));
}

namespace
{
const glm::ivec3 bricks(9, 7, 11);

// Single visible voxels leave free blocks of all sizes.
OpticalField FieldTowards(const glm::ivec3& towards)
{
  const glm::ivec3 dimensions = BrickRanges::CellsPerSide * bricks + 1;
  std::vector<std::uint8_t> voxels(std::size_t(dimensions.x) * dimensions.y * dimensions.z, 0);
  std::mt19937 random(5);
  for (int i = 0; i < 5; ++i)
  {
    voxels[random() % voxels.size()] = 200;
  }
  const OpticalTable table =
    BuildOpticalTable(TransferFunction({}, { { 20.0, 0.0 }, { 200.0, 0.5 } }, 1.0), 0.0, 255.0);
  const ScalarGrid<std::uint8_t> grid(voxels.data(), dimensions);
  return BuildOpticalField(
    BuildBrickRanges(grid, 0.0, 255.0), table, OpticalTolerance::Nothing(60.0), towards);
}

bool IsFree(const OpticalField& field, const glm::ivec3& first, const glm::ivec3& last)
{
  const glm::ivec3 lower = glm::max(first, 0);
  const glm::ivec3 upper = glm::min(last, bricks - 1);
  for (int z = lower.z; z <= upper.z; ++z)
  {
    for (int y = lower.y; y <= upper.y; ++y)
    {
      for (int x = lower.x; x <= upper.x; ++x)
      {
        if (field.bricks[(z * bricks.y + y) * bricks.x + x] < OpticalField::Invisible)
        {
          return false;
        }
      }
    }
  }
  return true;
}

class FieldTowardsEach : public testing::TestWithParam<std::tuple<int, int, int>>
{
};

}

TEST_P(FieldTowardsEach, HasTheLargestFreeBlocks)
{
  const auto [x, y, z] = GetParam();
  const glm::ivec3 towards(x, y, z);
  const OpticalField field = FieldTowards(towards);
  ASSERT_EQ(field.brickCount, bricks);
  const glm::ivec3 back(glm::lessThanEqual(towards, glm::ivec3(0)));
  const glm::ivec3 ahead(glm::greaterThanEqual(towards, glm::ivec3(0)));
  const int whole = glm::max(bricks.x, glm::max(bricks.y, bricks.z));
  int free = 0;
  for (int i = 0; i < int(field.bricks.size()); ++i)
  {
    if (field.bricks[i] < OpticalField::Invisible)
    {
      continue;
    }
    ++free;
    const glm::ivec3 brick(i % bricks.x, i / bricks.x % bricks.y, i / (bricks.x * bricks.y));
    const int radius = field.bricks[i] - OpticalField::Invisible;
    EXPECT_TRUE(IsFree(field, brick - radius * back, brick + radius * ahead));
    if (radius < whole)
    {
      EXPECT_FALSE(IsFree(field, brick - (radius + 1) * back, brick + (radius + 1) * ahead));
    }
  }
  EXPECT_GT(free, 500);
}

INSTANTIATE_TEST_SUITE_P(Directions, FieldTowardsEach,
  testing::Combine(testing::Range(-1, 2), testing::Range(-1, 2), testing::Range(-1, 2)));
