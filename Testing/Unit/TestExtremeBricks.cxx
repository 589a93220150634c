#include "Core/Fields/ExtremeBricks.h"

#include <glm/common.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using namespace varimarch;

namespace
{

// Random bricks of 16-bit values; one contains a value that is not finite.
BrickRanges RandomRanges()
{
  BrickRanges ranges(glm::ivec3(40, 40, 4), -1000.0, 3000.0, false);
  std::mt19937 random(7);
  std::uniform_int_distribution<int> step(0, 65535);
  for (std::size_t i = 0; i < 100; ++i)
  {
    const int a = step(random);
    const int b = step(random);
    ranges.Set(i, { std::uint16_t(std::min(a, b)), std::uint16_t(std::max(a, b)) });
  }
  ranges.Set(50, { 1, 0 });
  return ranges;
}

// A transfer function with plateaus, a step and a peak.
OpticalTable Table()
{
  return BuildOpticalTable(
    TransferFunction({ { 0.0, { 1.0, 0.3, 0.0 } }, { 900.0, { 0.2, 0.9, 0.9 } } },
      { { -300.0, 0.0 }, { 200.0, 0.3 }, { 800.0, 0.3 }, { 800.0, 0.7 }, { 1500.0, 0.6 },
        { 1520.0, 0.9 }, { 1540.0, 0.6 } },
      2.0),
    -1000.0, 3000.0);
}

glm::dvec4 Look(const OpticalTable& table, double value, double unitDistanceMm)
{
  const double last = double(table.entries.size()) - 1.0;
  const double place =
    std::clamp((value - table.firstValue) / (table.lastValue - table.firstValue) * last, 0.0, last);
  const auto below = std::min(std::size_t(place), table.entries.size() - 2);
  const glm::dvec4 optical =
    glm::mix(table.entries[below], table.entries[below + 1], float(place - double(below)));
  const double opacity = 1.0 - std::exp(-optical.a * unitDistanceMm);
  return { opacity * glm::dvec3(optical), opacity };
}

double LargestDifference(const glm::dvec4& a, const glm::dvec4& b)
{
  const glm::dvec4 difference = glm::abs(a - b);
  return std::max({ difference.r, difference.g, difference.b, difference.a });
}

}

TEST(ExtremeBricks, ValuesBetweenABricksExtremesLookNoBetter)
{
  const BrickRanges ranges = RandomRanges();
  const OpticalTable table = Table();
  for (const bool largest : { true, false })
  {
    for (const double tolerance : { 0.0, 1.0 / 255.0, 1.0 / 16.0 })
    {
      const ExtremeLook look{ table, 2.0, tolerance };
      const std::vector<std::uint16_t> extremes = BuildExtremeBricks(ranges, look, largest);
      ASSERT_EQ(extremes.size(), 100U);
      const auto valueOf = [&](double step)
      { return ranges.FirstValue() + step * ranges.ValuePerStep(); };
      int lower = 0;
      for (std::size_t i = 0; i < extremes.size(); ++i)
      {
        if (!ranges[i].IsFinite())
        {
          EXPECT_EQ(extremes[i], largest ? 65535 : 0) << "it may hold any value";
          continue;
        }
        const int extreme = largest ? ranges[i].largest : ranges[i].smallest;
        ASSERT_LE(largest ? extremes[i] : extreme, largest ? extreme : extremes[i]);
        lower += std::abs(extreme - extremes[i]) > 100;
        for (int part = 0; part <= 50; ++part)
        {
          const double between = extremes[i] + part / 50.0 * (extreme - extremes[i]);
          EXPECT_LE(LargestDifference(
                      Look(table, valueOf(extreme), 2.0), Look(table, valueOf(between), 2.0)),
            tolerance + 1e-6);
        }
      }
      EXPECT_GT(lower, 20) << "plateaus look the same throughout";
    }
  }
}

// Before its first value a ray stands beyond all of them, and must enter every brick.
TEST(ExtremeBricks, ABoundIsAValueOfTheVolumeIfAllLookTheSame)
{
  BrickRanges ranges(glm::ivec3(8, 8, 8), 10.0, 16.0, true);
  const OpticalTable table =
    BuildOpticalTable(TransferFunction({}, { { 0.0, 0.3 } }, 1.0), 10.0, 16.0);
  const auto boundOf = [&](bool largest) {
    return BuildExtremeBricks(ranges, { table, 1.0, 0.0 }, largest).front();
  };
  ranges.Set(0, { 2, 4 });
  EXPECT_EQ(boundOf(true), 0);
  EXPECT_EQ(boundOf(false), 6);
}

TEST(ExtremeBricks, ABlockIsAsTheBestOfItsBricks)
{
  const glm::ivec3 count(6, 5, 9); // not a multiple of the block size
  std::vector<std::uint16_t> bricks;
  for (int i = 0; i < count.x * count.y * count.z; ++i)
  {
    bricks.push_back(std::uint16_t(i * 40503 % 65536));
  }
  for (const bool largest : { true, false })
  {
    const ExtremeBlocks blocks = JoinExtremeBricks(bricks, count, largest);
    ASSERT_EQ(blocks.count, glm::ivec3(2, 2, 3));
    std::vector<std::uint16_t> expected(12, largest ? 0 : 65535);
    for (int i = 0; i < int(bricks.size()); ++i)
    {
      const int block = i % 6 / 4 + 2 * (i / 6 % 5 / 4) + 4 * (i / 30 / 4);
      expected[block] =
        largest ? std::max(expected[block], bricks[i]) : std::min(expected[block], bricks[i]);
    }
    EXPECT_EQ(blocks.steps, expected);
  }
}
