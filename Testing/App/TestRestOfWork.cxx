#include "CommandLine/Progress.h"

#include <gtest/gtest.h>

using varimarch::RestOfWork;

TEST(RestOfWork, IsThatOfWorkThatGoesOnAsItDid)
{
  EXPECT_EQ(RestOfWork(0.25, 140.0), ", about 7 minutes left");
  EXPECT_EQ(RestOfWork(0.01, 1000.0), ", about 28 hours left");
}

TEST(RestOfWork, IsNotSaidBeforeItIsKnownOrWhenItIsShort)
{
  EXPECT_EQ(RestOfWork(0.0, 100.0), "");
  EXPECT_EQ(RestOfWork(0.001, 2.0), "");
  EXPECT_EQ(RestOfWork(0.9, 100.0), "");
}
