#include "Core/Geometry/CellCubic.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace varimarch;

namespace
{

CellCorners RandomCorners(std::mt19937& random)
{
  std::uniform_real_distribution<double> value(-1.0, 1.0);
  CellCorners corners;
  for (double& corner : corners)
  {
    corner = value(random);
  }
  return corners;
}

glm::dvec3 RandomPlace(std::mt19937& random)
{
  std::uniform_real_distribution<double> value(0.0, 1.0);
  const double x = value(random), y = value(random);
  return { x, y, value(random) };
}

}

TEST(CellCubic, IsTrilinearInterpolationAlongTheLine)
{
  std::mt19937 random(1);
  for (int i = 0; i < 200; ++i)
  {
    const CellCorners corners = RandomCorners(random);
    const ScalarGrid<double> grid(corners.data(), glm::ivec3(2));
    const glm::dvec3 enter = RandomPlace(random), leave = RandomPlace(random);
    const CellCubic cubic(corners, enter, leave);
    for (const double u : { 0.0, 0.1, 0.5, 0.77, 1.0 })
    {
      EXPECT_NEAR(cubic.Value(u), grid.Value((1.0 - u) * enter + u * leave), 1e-15 * 10);
      EXPECT_GE(cubic.Value(u), cubic.LowerBound());
      EXPECT_LE(cubic.Value(u), cubic.UpperBound());
    }
  }
}

TEST(CellCubic, IsMonotoneBetweenItsCuts)
{
  std::mt19937 random(2);
  int extremes = 0;
  for (int i = 0; i < 500; ++i)
  {
    const CellCubic cubic(RandomCorners(random), RandomPlace(random), RandomPlace(random));
    const CellCubic::Cuts cuts = cubic.MonotoneCuts();
    extremes += cuts.count - 2;
    for (int piece = 0; piece + 1 < cuts.count; ++piece)
    {
      const double from = cuts.u[piece], to = cuts.u[piece + 1];
      const double sign = cubic.Value(to) < cubic.Value(from) ? -1.0 : 1.0;
      for (int k = 0; k < 50; ++k)
      {
        const double step = (to - from) / 50.0;
        EXPECT_GE(
          sign * (cubic.Value(from + (k + 1) * step) - cubic.Value(from + k * step)), -1e-15);
      }
    }
  }
  EXPECT_GT(extremes, 100);
}

TEST(CellCubic, CrossesAValueWhereItIsFound)
{
  std::mt19937 random(3);
  for (int i = 0; i < 500; ++i)
  {
    const CellCubic cubic(RandomCorners(random), RandomPlace(random), RandomPlace(random));
    const CellCubic::Cuts cuts = cubic.MonotoneCuts();
    for (int piece = 0; piece + 1 < cuts.count; ++piece)
    {
      const double from = cuts.u[piece], to = cuts.u[piece + 1];
      for (const double part : { 1e-9, 0.3, 0.9, 1.0 - 1e-9 })
      {
        const double value = (1.0 - part) * cubic.Value(from) + part * cubic.Value(to);
        const double u = cubic.Crossing(value, from, to);
        EXPECT_GE(u, from);
        EXPECT_LE(u, to);
        EXPECT_NEAR(cubic.Value(u), value, 2e-15);
      }
    }
  }
}

TEST(CellCubic, FindsATripleRoot)
{
  // (2u - 1)^3 has a zero slope at its root.
  const CellCubic cubic({ -1.0, 1.0, -1.0, 1.0 });
  EXPECT_NEAR(cubic.Crossing(1e-30, 0.0, 1.0), 0.5, 1e-5);
}

TEST(CornersOfCell, BeyondTheGridRepeatItsFaces)
{
  const double voxels[] = { 1.0, 2.0 };
  const ScalarGrid<double> grid(voxels, { 2, 1, 1 });
  const CellCorners inside = CornersOfCell(grid, { 0, -1, 0 });
  const CellCorners beyond = CornersOfCell(grid, { 1, 0, 0 });
  for (int i = 0; i < 8; ++i)
  {
    EXPECT_EQ(inside[i], i & 1 ? 2.0 : 1.0);
    EXPECT_EQ(beyond[i], 2.0);
  }
}
