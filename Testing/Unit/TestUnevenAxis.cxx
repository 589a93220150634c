#include "Core/UnevenAxis.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

using namespace varimarch;

namespace
{

// The voxel at a place of the grid, as a shader finds it.
double VoxelAt(const UnevenAxis& axis, double placeGrid)
{
  const std::vector<glm::vec4> bins = axis.Bins();
  const double part = (placeGrid - axis.LowerGrid()) / (axis.UpperGrid() - axis.LowerGrid());
  const int bin = std::clamp(int(part * double(bins.size())), 0, int(bins.size()) - 1);
  const glm::vec4 piece = bins[bin];
  const double beyond = placeGrid - piece.x;
  return piece.y + beyond * (beyond < 0.0 ? piece.z : piece.w);
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
    }
  }
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
    // The face between the second and the third, and the middle between their middles.
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
