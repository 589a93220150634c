#include "OpacityCurve.h"
#include "ReferenceVolumes.h"

#include "Core/Look/OpticalTable.h"

#include <glm/common.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

using namespace varimarch;

namespace
{

/// Lookup of a renderer: linear between entries, constant beyond the ends.
glm::vec4 LookUp(const OpticalTable& table, double value)
{
  const double last = double(table.entries.size() - 1);
  const double length = table.lastValue - table.firstValue;
  const double place =
    length > 0.0 ? std::min(std::max((value - table.firstValue) / length, 0.0), 1.0) * last : 0.0;
  const std::size_t lower = std::min(std::size_t(place), table.entries.size() - 2);
  return glm::mix(table.entries[lower], table.entries[lower + 1], float(place - double(lower)));
}

}

TEST(OpticalTable, AgreesWithALinearExtinctionEverywhere)
{
  // Opacity 1 - exp(-v) has the extinction v; this fine polyline is linear to 1e-6.
  std::vector<OpacityNode> nodes;
  for (int i = 0; i <= 1000; ++i)
  {
    nodes.push_back({ i * 0.002, -std::expm1(-i * 0.002) });
  }
  const OpticalTable table = BuildOpticalTable(OpacityCurve(nodes), -5.0, 5.0);
  EXPECT_EQ(table.firstValue, 0.0);
  EXPECT_EQ(table.lastValue, 2.0);
  for (double value = 0.0; value < 2.0; value += 0.0137)
  {
    EXPECT_NEAR(LookUp(table, value).a, value, 2e-6);
  }
  EXPECT_FLOAT_EQ(LookUp(table, 4.0).a, 2.0f);
  EXPECT_EQ(LookUp(table, -4.0).a, 0.0f);
}

TEST(OpticalTable, EntriesFollowTheClosestNodes)
{
  const auto entries = [](double peakWidth, std::size_t most)
  {
    const TransferFunction function =
      OpacityCurve({ { 0.0, 0.0 }, { 100.0, 0.0 }, { 100.0 + peakWidth, 0.5 }, { 1000.0, 0.0 } });
    return BuildOpticalTable(function, 0.0, 1000.0, most).entries.size();
  };
  EXPECT_EQ(entries(100.0, 65536), 1024u);
  EXPECT_EQ(entries(0.5, 65536), 65536u);
  EXPECT_EQ(entries(5.0, 65536), 8192u);
  EXPECT_EQ(entries(1e-6, 65536), 65536u);
  EXPECT_EQ(entries(1e-6, 10000), 8192u);
}

TEST(OpticalTable, ConstantFunctionGivesTwoEqualEntries)
{
  const TransferFunction function({ { 10.0, { 1.0, 0.0, 0.0 } }, { 20.0, { 0.0, 1.0, 0.0 } } },
    { { 10.0, 0.5 }, { 20.0, 0.8 } }, 1.0);
  const OpticalTable table = BuildOpticalTable(function, 30.0, 40.0);
  ASSERT_EQ(table.entries.size(), 2u);
  EXPECT_EQ(table.entries[0], table.entries[1]);
  EXPECT_EQ(table.entries[0].g, 1.0f);
  EXPECT_NEAR(table.entries[0].a, -std::log(0.2), 1e-6);
  EXPECT_EQ(BuildOpticalTable(function, 15.0, 15.0).entries.size(), 2u);
}

TEST(OpticalTable, OpaqueEntriesAreFinite)
{
  const OpticalTable table =
    BuildOpticalTable(OpacityCurve({ { 0.0, 0.0 }, { 1.0, 1.0 } }), 0.0, 1.0);
  EXPECT_EQ(table.entries.back().a, OpaqueExtinction);
  EXPECT_EQ(table.entries.back().a * 0.0f, 0.0f);
}

TEST(OpticalTable, AnOpaqueTipKeepsItsIntegralAndIsNoWall)
{
  // The mean of the extinction -log(1 - x) is 1 on either side of the tip, where an entry lies.
  const OpticalTable table =
    BuildOpticalTable(OpacityCurve({ { 0.0, 0.0 }, { 500.0, 1.0 }, { 1023.0, 0.0 } }), 0.0, 1023.0);
  ASSERT_EQ(table.entries.size(), 1024u);
  double integral = 0.0;
  for (const glm::vec4& entry : table.entries)
  {
    integral += entry.a;
  }
  EXPECT_NEAR(integral, 1023.0, 1.0);
}

// Up to one entry before the end of a ramp, its extinction is finite.
TEST(OpticalTable, ARampThatStaysOpaqueEndsWithinAThousandthOfItsValues)
{
  for (const std::vector<OpacityNode>& nodes :
    { std::vector<OpacityNode>{ { 0.0, 0.0 }, { 1.0, 1.0 }, { 2.0, 1.0 } },
      std::vector<OpacityNode>{ { 0.0, 1.0 }, { 1.0, 1.0 }, { 2.0, 0.0 } } })
  {
    const OpticalTable table = BuildOpticalTable(OpacityCurve(nodes), 0.0, 2.0);
    const auto isFinite = [](const glm::vec4& entry) { return entry.a < 1e6f; };
    const auto finite = std::count_if(table.entries.begin(), table.entries.end(), isFinite);
    const double gap = (table.lastValue - table.firstValue) / double(table.entries.size() - 1);
    EXPECT_GT(double(finite) * gap, 0.999);
  }
}

TEST(OpticalTable, ALoneStepSeparatesTheValuesBesideIt)
{
  const TransferFunction function = OpacityCurve({ { 100.0, 0.0 }, { 100.0, 0.5 } });
  const OpticalTable table = BuildOpticalTable(function, 0.0, 255.0);
  EXPECT_EQ(LookUp(table, 100.0).a, 0.0f);
  EXPECT_NEAR(LookUp(table, 100.01).a, std::log(2.0), 1e-6);
  EXPECT_NEAR(LookUp(table, 255.0).a, std::log(2.0), 1e-6);
}

TEST(OpticalTable, WholeNumbersAtStepsAreOnTheSideToWhichTheyBelong)
{
  const auto below = [](double value) { return std::nextafter(value, -infinity); };
  const TransferFunction function(
    { { below(2.0), glm::dvec3(0.1) }, { 2.0, glm::dvec3(0.2) }, { 5.0, glm::dvec3(0.2) },
      { 5.0, glm::dvec3(0.4) }, { 9.0, glm::dvec3(0.5) }, { 9.0, glm::dvec3(0.9) } },
    { { 0.0, 0.5 } }, 1.0);
  for (const double largest : { 9.0, 10.0, 255.0, 65535.0 })
  {
    const OpticalTable table = BuildOpticalTable(function, 0.0, largest);
    for (const double value : { 0.0, 1.0, 1.99, 2.0, 2.01, 4.0, 5.0, 5.99, 8.0, 9.0, 10.0 })
    {
      const bool isInRange = value <= largest && (largest < 300.0 || value == std::round(value));
      EXPECT_NEAR(
        isInRange ? LookUp(table, value).r : function.Color(value).r, function.Color(value).r, 1e-5)
        << value << " of " << largest;
    }
  }
}

TEST(OpticalTable, SpansOnlyTheValuesBetweenWhichTheLookChanges)
{
  const TransferFunction function({ { -1e20, glm::dvec3(0.0) }, { 300.0, glm::dvec3(1.0) } },
    { { -1e38, 0.0 }, { 60.0, 0.0 }, { 128.0, 0.2 }, { 255.0, 0.5 }, { 1e38, 0.5 } }, 1.0);
  const OpticalTable table = BuildOpticalTable(function, -LargestNumber, LargestNumber);
  EXPECT_EQ(table.firstValue, 60.0);
  EXPECT_EQ(table.lastValue, 300.0) << "the colour still changes there";
  EXPECT_FALSE(table.missesCurve);
  EXPECT_EQ(LookUp(table, -1e20).a, 0.0f);
  EXPECT_NEAR(LookUp(table, 128.0).a, function.Extinction(128.0), 1e-4) << "a node";
  EXPECT_NEAR(LookUp(table, 1e30).a, std::log(2.0), 1e-6);
}

TEST(OpticalTable, SaysThatItMissesACurveThatIsMuchNarrowerThanItsEntriesAreApart)
{
  const auto misses = [](double last)
  {
    const TransferFunction function =
      OpacityCurve({ { 60.0, 0.0 }, { 128.0, 0.2 }, { 255.0, 0.3 }, { last, 0.5 } });
    return BuildOpticalTable(function, 0.0, last).missesCurve;
  };
  EXPECT_FALSE(misses(1e6));
  EXPECT_TRUE(misses(1e20));
}

TEST(OpticalTable, HasIndicesForAllValuesHoweverSmallItsRange)
{
  const TransferFunction function = OpacityCurve({ { 0.0, 0.0 }, { 1e-310, 0.5 } });
  for (const double largest : { 5e-324, 1e-310, 2.5e-306, 1.0 })
  {
    const OpticalTable table = BuildOpticalTable(function, 0.0, largest);
    const double last = double(table.entries.size() - 1);
    for (const double scale : { 1e-300, 1.0, 1e300 })
    {
      const IndexInTable index = IndexOf(table, last, scale, 0.0);
      EXPECT_TRUE(std::isfinite(float(index.scale)) && std::isfinite(float(index.bias))) << scale;
    }
  }
}

TEST(OpticalTable, AReversedOrInfiniteRangeIsRefused)
{
  const TransferFunction function = OpacityCurve({ { 0.0, 0.5 } });
  EXPECT_THROW(BuildOpticalTable(function, 1.0, 0.0), std::invalid_argument);
  EXPECT_THROW(BuildOpticalTable(function, 0.0, infinity), std::invalid_argument);
  EXPECT_THROW(BuildOpticalTable(function, std::nan(""), 1.0), std::invalid_argument);
}

TEST(OpticalTable, APeakBetweenTwoEntriesKeepsItsIntegral)
{
  // Extinction of about 1e-3 (1 - |v - 500.5| / 0.01): an integral of 1e-5 between entries 1 apart.
  // A trace of opacity at either end makes the table that wide.
  const TransferFunction peak({},
    { { 0.0, 1e-12 }, { 1.0, 0.0 }, { 500.49, 0.0 }, { 500.5, 1e-3 }, { 500.51, 0.0 },
      { 1022.0, 0.0 }, { 1023.0, 1e-12 } },
    1.0);
  const OpticalTable table = BuildOpticalTable(peak, 0.0, 1023.0, 1024);
  ASSERT_EQ(table.entries.size(), 1024u);
  double integral = 0.0;
  for (const glm::vec4& entry : table.entries)
  {
    integral += entry.a;
  }
  EXPECT_NEAR(integral, 1e-5, 1e-8);
  EXPECT_EQ(table.entries[499].a, 0.0f);
  EXPECT_EQ(table.entries[502].a, 0.0f);
}

// A background has the end's value: the mean of a curve beside it would make it visible.
TEST(OpticalTable, ItsEndsAreExactHoweverNearTheNextNodeIs)
{
  const TransferFunction function =
    OpacityCurve({ { 0.0, 0.0 }, { 1e-6, 0.5 }, { 1000.0 - 1e-6, 0.4 }, { 1000.0, 0.0 } });
  const OpticalTable table = BuildOpticalTable(function, 0.0, 1000.0);
  EXPECT_EQ(table.entries.front().a, 0.0f);
  EXPECT_EQ(table.entries.back().a, 0.0f);
  EXPECT_GT(table.entries[1].a, 0.5f);
}

TEST(OpticalTable, AStepBeforeAllValuesIsOver)
{
  const TransferFunction function = OpacityCurve({ { 2.0, 0.3 }, { 4.0, 0.3 }, { 4.0, 0.0 } });
  const OpticalTable table = BuildOpticalTable(function, 7.0, 1e30);
  EXPECT_EQ(LookUp(table, 7.0).a, 0.0f);
  EXPECT_EQ(LookUp(table, 1e20).a, 0.0f);
}

TEST(OpticalTable, VisibleValuesEncloseAllThatAbsorbs)
{
  const auto visible = [](std::vector<OpacityNode> nodes)
  { return VisibleValues(BuildOpticalTable(OpacityCurve(std::move(nodes)), 0.0, 1000.0)); };
  const auto inside =
    visible({ { 0.0, 0.0 }, { 200.0, 0.0 }, { 300.0, 0.5 }, { 400.0, 0.0 }, { 1000.0, 0.0 } });
  EXPECT_NEAR(inside[0], 200.0, 1.0);
  EXPECT_LE(inside[0], 200.0);
  EXPECT_NEAR(inside[1], 400.0, 1.0);
  EXPECT_GE(inside[1], 400.0);

  const auto below = visible({ { 100.0, 0.5 }, { 300.0, 0.0 }, { 700.0, 0.0 }, { 900.0, 0.0 } });
  EXPECT_EQ(below[0], -infinity);
  EXPECT_NEAR(below[1], 300.0, 1.0);

  const auto above = visible({ { 100.0, 0.0 }, { 300.0, 0.0 }, { 700.0, 0.5 } });
  EXPECT_NEAR(above[0], 300.0, 1.0);
  EXPECT_EQ(above[1], infinity);

  const auto nothing = visible({ { 0.0, 0.0 }, { 1000.0, 0.0 } });
  EXPECT_GT(nothing[0], nothing[1]);
}
