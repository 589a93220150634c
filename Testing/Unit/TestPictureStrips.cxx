#include "Core/Quality/PictureStrips.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace varimarch;

namespace
{

constexpr int Rows = 1000;

// Draws an image strip by strip on a machine of the given speed; returns the longest time of a
// strip [s].
double LongestStrip(PictureStrips& strips, double rowsPerSecond, double asked)
{
  double longest = 0.0;
  strips.Restart();
  while (strips.Done() < Rows)
  {
    const PictureStrips::Rows strip = strips.Next(Rows, asked);
    EXPECT_EQ(strip.begin, strips.Done());
    EXPECT_GT(strip.count, 0);
    longest = std::max(longest, strip.count / rowsPerSecond);
    strips.Took(strip, strip.count / rowsPerSecond, asked);
  }
  EXPECT_EQ(strips.Done(), Rows);
  return longest;
}

}

TEST(PictureStrips, TakeAsLongAsIsAskedOnceTimesAreKnown)
{
  for (double rowsPerSecond : { 50.0, 700.0, 4000.0 })
  {
    PictureStrips strips;
    LongestStrip(strips, rowsPerSecond, 0.2);
    EXPECT_TRUE(strips.IsDivided(Rows)) << rowsPerSecond;
    EXPECT_NEAR(LongestStrip(strips, rowsPerSecond, 0.2), 0.2, 0.02) << rowsPerSecond;
  }
}

TEST(PictureStrips, AreOneWhereThereIsTime)
{
  PictureStrips strips;
  EXPECT_TRUE(strips.IsDivided(Rows)) << "while nothing is known";
  LongestStrip(strips, 1e6, 0.2);
  EXPECT_FALSE(strips.IsDivided(Rows));
  strips.Restart();
  EXPECT_EQ(strips.Next(Rows, 0.2).count, Rows);
}

// The last strip of the image has 26 rows.
TEST(PictureStrips, StayAsHighAfterAShortRest)
{
  PictureStrips strips;
  LongestStrip(strips, 1660.0, 0.2);
  strips.Restart();
  EXPECT_NEAR(strips.Next(Rows, 0.2).count, 332, 2);
}

TEST(PictureStrips, AreAllThatIsLeftWhereNobodyAsksForLess)
{
  PictureStrips strips;
  strips.Took(strips.Next(Rows, 0.2), 10.0, 0.2);
  const PictureStrips::Rows rest = strips.Next(Rows, 0.0);
  EXPECT_EQ(rest.begin + rest.count, Rows);
  EXPECT_EQ(rest.begin, strips.Done());
}

TEST(PictureStrips, AreNeverEmptyHoweverLongTheyTake)
{
  PictureStrips strips;
  LongestStrip(strips, 0.1, 0.2);
  EXPECT_GE(strips.Next(Rows, 0.2).count + strips.Done(), 1);
  EXPECT_EQ(PictureStrips().Next(3, 0.2).count, 3) << "a picture of three rows";
}
