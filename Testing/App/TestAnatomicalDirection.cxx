#include "Scene/Slices/SliceAxes.h"

#include <gtest/gtest.h>

namespace
{

std::string Letters(double x, double y, double z)
{
  const double direction[3] = { x, y, z };
  return varimarch::AnatomicalDirection(direction);
}

TEST(AnatomicalDirection, WorldAxesAreLps)
{
  EXPECT_EQ(Letters(1, 0, 0), "L");
  EXPECT_EQ(Letters(-1, 0, 0), "R");
  EXPECT_EQ(Letters(0, 1, 0), "P");
  EXPECT_EQ(Letters(0, -1, 0), "A");
  EXPECT_EQ(Letters(0, 0, 1), "S");
  EXPECT_EQ(Letters(0, 0, -1), "I");
}

TEST(AnatomicalDirection, NamesTheNearestFirstAndLeavesOutTheNegligible)
{
  EXPECT_EQ(Letters(-0.3, -0.9, 0.01), "AR");
  EXPECT_EQ(Letters(0, 0, 0), "");
}

}
