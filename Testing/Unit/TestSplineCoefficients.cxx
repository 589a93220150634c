#include "Core/Fields/BrickRanges.h"
#include "Core/Geometry/SplineCoefficients.h"
#include "Core/Reference/SplineGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace varimarch;

namespace
{

std::vector<double> RandomVoxels(glm::ivec3 dimensions, unsigned seed = 1)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> value(-1000.0, 2000.0);
  std::vector<double> voxels(std::size_t(dimensions.x) * dimensions.y * dimensions.z);
  std::generate(voxels.begin(), voxels.end(), [&] { return value(random); });
  return voxels;
}

// Voxel values of a spline with these coefficients.
std::vector<double> VoxelsOf(std::vector<double> coefficients, glm::ivec3 dimensions)
{
  int stride = 1;
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::vector<double> before = coefficients;
    for (int i = 0; i < int(before.size()); ++i)
    {
      const int place = i / stride % dimensions[axis];
      const double below = before[place > 0 ? i - stride : i];
      const double above = before[place + 1 < dimensions[axis] ? i + stride : i];
      coefficients[i] = (below + 4.0 * before[i] + above) / 6.0;
    }
    stride *= dimensions[axis];
  }
  return coefficients;
}

template <class Visit>
void ForEachVoxel(glm::ivec3 dimensions, Visit visit)
{
  std::size_t index = 0;
  for (int z = 0; z < dimensions.z; ++z)
  {
    for (int y = 0; y < dimensions.y; ++y)
    {
      for (int x = 0; x < dimensions.x; ++x)
      {
        visit(glm::ivec3(x, y, z), index++);
      }
    }
  }
}

}

TEST(SplineCoefficients, MakeASplineThatKeepsEveryVoxel)
{
  for (const glm::ivec3 dimensions : { glm::ivec3(1, 1, 1), glm::ivec3(2, 1, 3),
         glm::ivec3(5, 2, 1), glm::ivec3(4, 7, 3), glm::ivec3(40, 3, 9) })
  {
    const std::vector<double> voxels = RandomVoxels(dimensions);
    const SplineGrid grid(voxels, dimensions);
    ForEachVoxel(dimensions,
      [&](glm::ivec3 voxel, std::size_t index)
      { EXPECT_NEAR(grid.Value(glm::dvec3(voxel)), voxels[index], 1e-9); });
  }
}

TEST(SplineCoefficients, InSinglePrecisionKeepVoxelsToItsLastBits)
{
  const glm::ivec3 dimensions(20, 6, 5);
  const std::vector<double> voxels = RandomVoxels(dimensions);
  std::vector<float> single(voxels.begin(), voxels.end());
  std::vector<double> exact = voxels;
  TurnIntoSplineCoefficients(single.data(), dimensions);
  TurnIntoSplineCoefficients(exact.data(), dimensions);
  for (std::size_t i = 0; i < exact.size(); ++i)
  {
    EXPECT_NEAR(single[i], exact[i], 2e-3) << "values up to 2000, coefficients up to 10000";
  }
}

TEST(SplineCoefficients, ReproduceACubicAwayFromTheFaces)
{
  const auto cubic = [](glm::dvec3 p)
  { return 0.02 * p.x * p.x * p.x - 0.3 * p.y * p.y + p.x * p.z + 2.0; };
  const glm::ivec3 dimensions(64, 64, 64);
  std::vector<double> voxels;
  ForEachVoxel(
    dimensions, [&](glm::ivec3 voxel, std::size_t) { voxels.push_back(cubic(glm::dvec3(voxel))); });
  const SplineGrid grid(voxels, dimensions);
  for (const glm::dvec3 position :
    { glm::dvec3(31.3, 30.7, 32.1), glm::dvec3(33.9, 31.0, 29.5), glm::dvec3(30.01, 33.3, 31.99) })
  {
    EXPECT_NEAR(grid.Value(position), cubic(position), 1e-6);
    const glm::dvec3 slope(
      0.06 * position.x * position.x + position.z, -0.6 * position.y, position.x);
    const glm::dvec3 gradient = grid.Gradient(position);
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_NEAR(gradient[axis], slope[axis], 1e-6);
    }
  }
}

TEST(SplineGrid, HasTheGradientThatItsValuesHave)
{
  const glm::ivec3 dimensions(6, 5, 4);
  const SplineGrid grid(RandomVoxels(dimensions), dimensions);
  constexpr double h = 1e-5;
  for (const glm::dvec3 position : { glm::dvec3(0.3, 1.6, 2.2), glm::dvec3(4.7, 3.1, 0.4) })
  {
    const glm::dvec3 gradient = grid.Gradient(position);
    for (int axis = 0; axis < 3; ++axis)
    {
      glm::dvec3 step(0.0);
      step[axis] = h;
      EXPECT_NEAR(gradient[axis],
        (grid.Value(position + step) - grid.Value(position - step)) / (2.0 * h), 1e-4);
    }
  }
}

TEST(SplineGrid, StaysWithinTheBrickRangesOfItsCoefficients)
{
  // Only a few coefficients are not 0, and adjacent bricks must include them too.
  const glm::ivec3 dimensions(14, 11, 9);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  std::vector<double> coefficients(14 * 11 * 9);
  for (double& coefficient : coefficients)
  {
    coefficient = part(random) < 0.02 ? 2000.0 * part(random) - 1000.0 : 0.0;
  }
  const auto [least, most] = std::minmax_element(coefficients.begin(), coefficients.end());
  const BrickRanges ranges = BuildBrickRanges(
    ScalarGrid<double>(coefficients.data(), dimensions), *least, *most, SplineReachVoxels);
  const SplineGrid spline(VoxelsOf(coefficients, dimensions), dimensions);
  const glm::ivec3 bricks = ranges.BrickCount();
  for (int i = 0; i < 20000; ++i)
  {
    const glm::dvec3 position =
      glm::dvec3(part(random), part(random), part(random)) * glm::dvec3(dimensions - 1);
    const glm::ivec3 brick = glm::ivec3(position) / BrickRanges::CellsPerSide;
    const BrickRanges::Steps steps =
      ranges[std::size_t(brick.z * bricks.y + brick.y) * bricks.x + brick.x];
    const double value = spline.Value(position);
    EXPECT_GE(value, ranges.FirstValue() + steps.smallest * ranges.ValuePerStep() - 1e-9);
    EXPECT_LE(value, ranges.FirstValue() + steps.largest * ranges.ValuePerStep() + 1e-9);
  }
}
