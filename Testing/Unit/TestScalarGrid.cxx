#include "Core/Geometry/ScalarGrid.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

using namespace varimarch;

namespace
{

/// A function that is linear along each axis, which trilinear interpolation reproduces.
double Multilinear(glm::dvec3 p)
{
  return 3.0 + 2.0 * p.x - p.y + 0.5 * p.z + 0.25 * p.x * p.y - p.y * p.z + 0.125 * p.x * p.y * p.z;
}

std::vector<double> MultilinearVoxels(glm::ivec3 dimensions)
{
  std::vector<double> voxels;
  for (int z = 0; z < dimensions.z; ++z)
  {
    for (int y = 0; y < dimensions.y; ++y)
    {
      for (int x = 0; x < dimensions.x; ++x)
      {
        voxels.push_back(Multilinear({ x, y, z }));
      }
    }
  }
  return voxels;
}

}

TEST(ScalarGrid, InterpolationKeepsMultilinearFunctions)
{
  const glm::ivec3 dimensions(4, 3, 5);
  const std::vector<double> voxels = MultilinearVoxels(dimensions);
  const ScalarGrid<double> grid(voxels.data(), dimensions);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> fraction(0.0, 1.0);
  for (int i = 0; i < 1000; ++i)
  {
    const glm::dvec3 position =
      glm::dvec3(fraction(random), fraction(random), fraction(random)) * glm::dvec3(dimensions - 1);
    EXPECT_NEAR(grid.Value(position), Multilinear(position), 1e-12);
  }
}

TEST(ScalarGrid, VoxelPositionsGiveTheVoxels)
{
  const glm::ivec3 dimensions(4, 3, 5);
  const std::vector<double> voxels = MultilinearVoxels(dimensions);
  const ScalarGrid<double> grid(voxels.data(), dimensions);
  EXPECT_EQ(grid.Value({ 0, 0, 0 }), voxels.front());
  EXPECT_EQ(grid.Value({ 3, 2, 4 }), voxels.back());
  EXPECT_EQ(grid.Value({ 1, 2, 3 }), voxels[1 + 4 * (2 + 3 * 3)]);
}

TEST(ScalarGrid, PositionsOutsideAreClampedToTheFace)
{
  const glm::ivec3 dimensions(4, 3, 5);
  const std::vector<double> voxels = MultilinearVoxels(dimensions);
  const ScalarGrid<double> grid(voxels.data(), dimensions);
  EXPECT_EQ(grid.Value({ -7.0, 0.5, 2.5 }), grid.Value({ 0.0, 0.5, 2.5 }));
  EXPECT_EQ(grid.Value({ 1.5, 99.0, 2.5 }), grid.Value({ 1.5, 2.0, 2.5 }));
}

TEST(ScalarGrid, OneVoxelIsConstantAndHasOneCell)
{
  const short voxel = -5;
  const ScalarGrid<short> grid(&voxel, glm::ivec3(1));
  EXPECT_EQ(grid.Value({ 0.0, 0.0, 0.0 }), -5.0);
  EXPECT_EQ(grid.Value({ 9.0, -9.0, 0.3 }), -5.0);
  EXPECT_EQ(grid.CellCount(), glm::ivec3(1));
}

TEST(ScalarGrid, IntegersAtTheEndsOfTheirTypeDoNotOverflow)
{
  const std::vector<int> voxels{ std::numeric_limits<int>::min(), std::numeric_limits<int>::max() };
  const ScalarGrid<int> grid(voxels.data(), { 2, 1, 1 });
  EXPECT_DOUBLE_EQ(grid.Value({ 0.5, 0.0, 0.0 }), -0.5);
}

TEST(ScalarGrid, GradientOfALinearFunctionIsPerMm)
{
  const glm::ivec3 dimensions(5, 5, 5);
  std::vector<float> voxels;
  for (int i = 0; i < 125; ++i)
  {
    voxels.push_back(float(2 * (i % 5) - 3 * (i / 5 % 5) + 4 * (i / 25)));
  }
  const ScalarGrid<float> grid(voxels.data(), dimensions, { 0.5, 1.0, 2.0 });
  const glm::dvec3 gradient = grid.Gradient({ 2.3, 1.6, 2.9 });
  EXPECT_NEAR(gradient.x, 4.0, 1e-12);
  EXPECT_NEAR(gradient.y, -3.0, 1e-12);
  EXPECT_NEAR(gradient.z, 2.0, 1e-12);
}

TEST(ScalarGrid, APartHoldsTheVoxelsOfItsRegion)
{
  std::vector<int> voxels(5 * 4 * 3);
  std::iota(voxels.begin(), voxels.end(), 0);
  const ScalarGrid<int> grid(voxels.data(), { 5, 4, 3 });
  const glm::ivec3 first(1, 2, 1);
  const ScalarGrid<int> part = grid.Part({ first, { 3, 2, 2 } }).Part({ { 1, 0, 0 }, { 2, 2, 2 } });
  EXPECT_EQ(part.Dimensions(), glm::ivec3(2));
  for (const glm::ivec3& index : { glm::ivec3(0), glm::ivec3(1, 0, 1), glm::ivec3(0, 1, 0) })
  {
    EXPECT_EQ(part.Voxel(index), grid.Voxel(first + glm::ivec3(1, 0, 0) + index));
  }
}
