#include "Core/Blocks/OwnerOrder.h"

#include <gtest/gtest.h>

using namespace varimarch;

namespace
{

constexpr Box UnitCube{ glm::dvec3(0.0), glm::dvec3(1.0) };

}

TEST(BoxOverlap, IsThatOfTheFirstTwoBoxes)
{
  Box other{ glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(2.0, 1.0, 1.0) };
  EXPECT_FALSE(FirstOverlap({ UnitCube, other }));
  other.lower.x = 1.0 - 1e-9; // by rounding
  EXPECT_FALSE(FirstOverlap({ UnitCube, other }));
  other.lower.x = 0.99;
  const Box far{ glm::dvec3(5.0), glm::dvec3(6.0) };
  const std::pair<int, int> overlap(0, 2);
  EXPECT_EQ(FirstOverlap({ UnitCube, far, other }), overlap);
}
