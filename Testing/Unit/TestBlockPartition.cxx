#include "Core/Blocks/BlockPartition.h"

#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace varimarch;

namespace
{

Box BoxOfGrid(glm::ivec3 dimensions)
{
  Box box{ glm::dvec3(0.0), glm::dvec3(dimensions - 1) };
  for (int axis = 0; axis < 3; ++axis)
  {
    if (dimensions[axis] == 1)
    {
      box.lower[axis] = -0.5;
      box.upper[axis] = 0.5;
    }
  }
  return box;
}

struct Case
{
  glm::ivec3 dimensions;
  BlockLimits limits;
};

const std::vector<Case> cases = { { { 40, 36, 30 }, { 64, 2, 40000 } },
  { { 40, 36, 30 }, { 64, 2, 8000 } }, { { 100, 7, 1 }, { 16, 4, 4000 } },
  { { 5000, 2, 3 }, { 2048, 2, 1 << 30 } }, { { 33, 9, 65 }, { 1024, 4, 7 * 7 * 7 * 4 } } };

}

TEST(BlockPartition, AVolumeWithinTheLimitsIsOneBlock)
{
  const glm::ivec3 dimensions(40, 36, 30);
  const BlockPartition partition(dimensions, { 40, 2, 40 * 36 * 30 * 2 });
  ASSERT_EQ(partition.Count(), 1);
  EXPECT_EQ(partition.VoxelsOf(0).first, glm::ivec3(0));
  EXPECT_EQ(partition.VoxelsOf(0).count, dimensions);
  EXPECT_GT(BlockPartition(dimensions, { 39, 2, 40 * 36 * 30 * 2 }).Count(), 1);
  EXPECT_GT(BlockPartition(dimensions, { 40, 2, 40 * 36 * 30 * 2 - 1 }).Count(), 1);
}

TEST(BlockPartition, CoversEveryCellOnce)
{
  for (const Case& scene : cases)
  {
    const BlockPartition partition(scene.dimensions, scene.limits);
    const Box boxGrid = BoxOfGrid(scene.dimensions);
    const glm::ivec3 cells = glm::max(scene.dimensions - 1, glm::ivec3(1));
    for (int z = 0; z < cells.z; ++z)
    {
      for (int y = 0; y < cells.y; ++y)
      {
        for (int x = 0; x < cells.x; ++x)
        {
          const glm::dvec3 middle =
            glm::clamp(glm::dvec3(x, y, z) + 0.5, boxGrid.lower + 0.25, boxGrid.upper - 0.25);
          int covering = 0;
          for (int block = 0; block < partition.Count(); ++block)
          {
            const Box box = partition.BoxOf(block, boxGrid);
            covering += glm::all(glm::greaterThan(middle, box.lower)) &&
              glm::all(glm::lessThan(middle, box.upper));
          }
          ASSERT_EQ(covering, 1) << x << " " << y << " " << z;
        }
      }
    }
  }
}

TEST(BlockPartition, HoldsWhatGradientsReadWithinTheLimits)
{
  for (const Case& scene : cases)
  {
    const BlockPartition partition(scene.dimensions, scene.limits);
    const Box boxGrid = BoxOfGrid(scene.dimensions);
    for (int block = 0; block < partition.Count(); ++block)
    {
      const VoxelRegion voxels = partition.VoxelsOf(block);
      const Box box = partition.BoxOf(block, boxGrid);
      const glm::ivec3 last = voxels.first + voxels.count - 1;
      EXPECT_LE(
        std::size_t(voxels.count.x) * voxels.count.y * voxels.count.z * scene.limits.bytesPerVoxel,
        scene.limits.largestBytes);
      for (int axis = 0; axis < 3; ++axis)
      {
        EXPECT_LE(voxels.count[axis], scene.limits.largestSide);
        EXPECT_LE(voxels.first[axis], std::max(box.lower[axis] - 1.0, 0.0));
        EXPECT_GE(last[axis], std::min(box.upper[axis] + 1.0, scene.dimensions[axis] - 1.0));
      }
    }
  }
}

TEST(BlockPartition, LimitsTooSmallForTheSmallestBlockAreNamed)
{
  try
  {
    BlockPartition({ 40, 36, 30 }, { 64, 2, 685 });
    FAIL() << "no exception";
  }
  catch (const std::runtime_error& problem)
  {
    EXPECT_EQ(std::string(problem.what()),
      "Cannot divide the volume into blocks of at most 685 bytes: the smallest possible block "
      "needs 686 bytes");
  }
}

// The rays start at random eyes in front of, behind and within the volume, and at infinity.
TEST(BlockPartition, OrdersBlocksFrontToBackForEveryEye)
{
  const glm::ivec3 dimensions(40, 36, 30);
  const Box boxGrid = BoxOfGrid(dimensions);
  const BlockPartition partition(dimensions, { 64, 2, 8000 });
  ASSERT_GT(partition.Count(), 8);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> anywhere(-1.0, 1.0);
  const auto point = [&](double reach)
  { return reach * glm::dvec3(anywhere(random), anywhere(random), anywhere(random)); };
  for (int trial = 0; trial < 200; ++trial)
  {
    const bool isParallel = trial % 4 == 0;
    const glm::dvec3 toEye = point(1.0);
    const glm::dvec3 eye = 0.5 * boxGrid.upper + point(trial % 2 ? 15.0 : 60.0);
    const std::vector<int> order =
      partition.FrontToBack(isParallel ? glm::dvec4(toEye, 0.0) : glm::dvec4(eye, 1.0));
    ASSERT_EQ(int(order.size()), partition.Count());
    for (int i = 0; i < 50; ++i)
    {
      const glm::dvec3 target = 0.5 * boxGrid.upper + point(15.0);
      const Ray ray = isParallel ? Ray{ target + 200.0 * toEye, -toEye } : Ray{ eye, target - eye };
      double behind = 0.0;
      for (int block : order)
      {
        const Interval inside = Intersection(ray, partition.BoxOf(block, boxGrid));
        if (inside.exit - inside.enter > 1e-9)
        {
          EXPECT_GE(inside.enter, behind - 1e-9);
          behind = inside.exit;
        }
      }
    }
  }
}
