#include "OpacityCurve.h"

#include "Core/Look/OpticalTable.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace varimarch;

namespace
{

// The opaque ones of the values 0 to 10.
std::vector<ValueRange> OpaqueIn(const std::vector<OpacityNode>& nodes)
{
  return OpaqueValues(OpacityCurve(nodes), { 0.0, 10.0 });
}

}

TEST(OpaqueValues, ReachToInfinityWhereAFunctionStaysOpaque)
{
  const auto rising = OpaqueIn({ { 1.0, 0.0 }, { 2.0, 1.0 } });
  ASSERT_EQ(rising.size(), 1u);
  EXPECT_EQ(rising[0].lower, 2.0);
  EXPECT_TRUE(std::isinf(rising[0].upper));
  const auto falling = OpaqueIn({ { 1.0, 1.0 }, { 2.0, 0.0 } });
  ASSERT_EQ(falling.size(), 1u);
  EXPECT_TRUE(std::isinf(falling[0].lower));
  EXPECT_EQ(falling[0].upper, 1.0);
}

TEST(OpaqueValues, LieBetweenTheNodesOfAPlateau)
{
  const auto ranges = OpaqueIn({ { 0.0, 0.0 }, { 1.0, 1.0 }, { 2.0, 1.0 }, { 3.0, 0.5 },
    { 4.0, 1.0 }, { 5.0, 1.0 }, { 6.0, 0.0 } });
  ASSERT_EQ(ranges.size(), 2u);
  EXPECT_EQ(ranges[0].lower, 1.0);
  EXPECT_EQ(ranges[0].upper, 2.0);
  EXPECT_EQ(ranges[1].lower, 4.0);
  EXPECT_EQ(ranges[1].upper, 5.0);
}

TEST(OpaqueValues, LeaveOutTipsAndWhatIsNearlyOpaque)
{
  EXPECT_TRUE(OpaqueIn({ { 0.0, 0.0 }, { 1.0, 1.0 }, { 2.0, 0.0 } }).empty());
  EXPECT_TRUE(OpaqueIn({ { 0.0, 0.0 }, { 1.0, 0.999 } }).empty());
}

TEST(OpaqueValues, LeaveOutRangesOfWhichAllOrNoneOccur)
{
  EXPECT_TRUE(OpaqueIn({ { 0.0, 1.0 }, { 1.0, 1.0 } }).empty());
  EXPECT_TRUE(OpaqueIn({ { -2.0, 0.0 }, { -1.0, 1.0 } }).empty());
  EXPECT_TRUE(OpaqueIn({ { 10.0, 0.0 }, { 11.0, 1.0 } }).empty());
  EXPECT_EQ(OpaqueIn({ { 9.0, 0.0 }, { 10.0, 1.0 } }).size(), 1u);
}
