#include "Core/Fields/BrickRanges.h"
#include "Core/Geometry/UnevenAxis.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <stdexcept>
#include <vector>

using namespace varimarch;

namespace
{

// The voxel coordinate at a grid position, as computed by a shader.
double VoxelAt(const UnevenAxis& axis, double placeGrid)
{
  const std::vector<glm::vec4> bins = axis.Bins();
  const double part = (placeGrid - axis.LowerGrid()) / (axis.UpperGrid() - axis.LowerGrid());
  const int bin = std::clamp(int(part * double(bins.size())), 0, int(bins.size()) - 1);
  const glm::vec4 piece = bins[bin];
  const double beyond = placeGrid - piece.x;
  return piece.y + beyond * (beyond < 0.0 ? piece.z : piece.w);
}

// Coordinates whose random spacing shrinks along the axis.
UnevenAxis RandomAxis(int count, std::mt19937& random)
{
  std::uniform_real_distribution<double> gap(0.5, 1.0);
  std::vector<double> points = { 2.0 };
  for (int i = 1; i < count; ++i)
  {
    points.push_back(points.back() + gap(random) * (count - i + 3) * (count - i + 3));
  }
  return UnevenAxis(points, false, false);
}

}

TEST(UnevenAxis, EachPlaceIsBetweenTheVoxelsThatItIsBetween)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> gap(0.02, 1.0);
  std::vector<double> points = { -4.0 };
  for (int i = 0; i < 40; ++i)
  {
    points.push_back(points.back() + gap(random));
  }
  const UnevenAxis axis(points, false, false);
  EXPECT_EQ(axis.VoxelCount(), 41);
  EXPECT_NEAR(axis.UpperGrid(), 40.0, 1e-12);
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
  {
    for (const double part : { 0.0, 0.3, 0.9 })
    {
      const double place = points[i] + part * (points[i + 1] - points[i]);
      const double placeGrid = (place - axis.FirstVoxel()) / axis.Step();
      EXPECT_NEAR(VoxelAt(axis, placeGrid), double(i) + part, 1e-3);
      EXPECT_NEAR(axis.VoxelAt(placeGrid), double(i) + part, 1e-9);
    }
  }
}

// One half of the volume is noise, the other half empty.
TEST(UnevenAxis, BricksOfTheEvenGridHoldWhatIsThere)
{
  const glm::ivec3 size(37, 41, 30);
  std::mt19937 random(5);
  std::vector<std::uint8_t> voxels(std::size_t(size.x) * size.y * size.z);
  for (std::size_t i = 0; i < voxels.size(); ++i)
  {
    voxels[i] = i < voxels.size() / 2 ? std::uint8_t(random() % 256) : 0;
  }
  const std::vector<UnevenAxis> axes = { RandomAxis(size.x, random), RandomAxis(size.y, random),
    RandomAxis(size.z, random) };
  const ScalarGrid<std::uint8_t> grid(voxels.data(), size);
  const BrickRanges bricks = EvenBricks(BuildBrickRanges(grid, 0.0, 255.0), axes);
  const glm::ivec3 count = bricks.BrickCount();
  std::uniform_real_distribution<double> place(-0.5, 1.5);
  int clear = 0;
  for (int trial = 0; trial < 20000; ++trial)
  {
    glm::dvec3 voxel(0.0);
    glm::ivec3 brick;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double placeGrid = place(random) * (size[axis] - 1);
      voxel[axis] = axes[axis].VoxelAt(placeGrid);
      brick[axis] =
        std::clamp(int(std::floor(placeGrid / BrickRanges::CellsPerSide)), 0, count[axis] - 1);
    }
    const BrickRanges::Steps steps =
      bricks[brick.x + std::size_t(count.x) * (brick.y + std::size_t(count.y) * brick.z)];
    const double value = grid.Value(voxel);
    ASSERT_GE(value, double(steps.smallest));
    ASSERT_LE(value, double(steps.largest));
    clear += steps.largest == 0 ? 1 : 0;
  }
  EXPECT_GT(clear, 4000) << "empty bricks are not distinguished from others";
}

TEST(UnevenAxis, CellsReachFromTheFirstPointToTheLast)
{
  const std::vector<double> points = { 0.0, 1.0, 3.0, 7.0 };
  for (const bool nearest : { false, true })
  {
    const UnevenAxis axis(points, true, nearest);
    EXPECT_EQ(axis.VoxelCount(), 3);
    EXPECT_NEAR(axis.FirstVoxel() + axis.LowerGrid() * axis.Step(), 0.0, 1e-12);
    EXPECT_NEAR(axis.FirstVoxel() + axis.UpperGrid() * axis.Step(), 7.0, 1e-12);
    const auto voxelAt = [&](double place)
    { return VoxelAt(axis, (place - axis.FirstVoxel()) / axis.Step()); };
    EXPECT_NEAR(voxelAt(2.0), 1.0, 1e-4) << "the middle of the second cell";
    // The face between the second and third cells, and the midpoint between their centres.
    EXPECT_NEAR(voxelAt(nearest ? 3.0 : 3.5), 1.5, 1e-4);
  }
}

TEST(UnevenAxis, CoordinatesThatDoNotAscendAreRefused)
{
  EXPECT_THROW(UnevenAxis({ 0.0, 1.0, 1.0 }, false, false), std::invalid_argument);
  EXPECT_THROW(UnevenAxis({ 0.0, std::nan(""), 1.0 }, false, false), std::invalid_argument);
  EXPECT_THROW(UnevenAxis({ 0.0, 1e-9, 1.0 }, false, false), std::invalid_argument);
  EXPECT_EQ(UnevenAxis({ 5.0 }, false, false).VoxelCount(), 1);
}
