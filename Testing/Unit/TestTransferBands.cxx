#include "Core/Look/TransferBands.h"

#include <gtest/gtest.h>

#include <random>

using namespace varimarch;

TEST(TransferBands, PropertiesAtTheEndsOfABandAreThoseInside)
{
  // Steps lie at midpoints that no double represents exactly, so the ends must round to their band.
  std::mt19937 random(1);
  std::uniform_real_distribution<double> number(0.0, 1.0);
  for (int i = 0; i < 1000; ++i)
  {
    const double left = -number(random);
    const double right = number(random);
    const NodeShape step{ number(random), 1.0 };
    const TransferBands bands({ {}, { { left, 0.2, step }, { right, 0.6 } }, 1.0 });
    const double there = HalfWayValue(left, right, step);
    for (const int index : { bands.BandBelow(there), bands.BandAbove(there) })
    {
      const TransferBands::Band band = bands[index];
      ASSERT_EQ(band.kind, TransferBands::Kind::Constant);
      const double inside = bands.Inside(band, 0.5 * (band.lower + band.upper)).extinction;
      ASSERT_EQ(bands.Inside(band, band.lower).extinction, inside);
      ASSERT_EQ(bands.Inside(band, band.upper).extinction, inside);
    }
  }
}

TEST(TransferBands, OnlyWhatLetsNothingThroughIsOpaque)
{
  // The opacity from 3.9 to 4 rounds to 1 everywhere, but the extinction reaches infinity only
  // at 4.
  const TransferBands bands(
    { {}, { { 0.0, 0.0, { 0.5, 0.98 } }, { 4.0, 1.0 }, { 5.0, 1.0 } }, 1.0 }, { 3.9 });
  EXPECT_EQ(bands[bands.BandBelow(3.95)].kind, TransferBands::Kind::Varying);
  EXPECT_EQ(bands[bands.BandBelow(4.5)].kind, TransferBands::Kind::Opaque);
}

TEST(TransferBands, VisibilityOfARangeFollowsItsBands)
{
  const TransferBands bands(
    { {}, { { 1.0, 0.0 }, { 2.0, 0.5 }, { 2.0, 0.0 }, { 4.0, 0.0 }, { 5.0, 1.0 } }, 1.0 });
  EXPECT_FALSE(bands.MayBeVisible(-9.0, 1.0));
  EXPECT_TRUE(bands.MayBeVisible(-9.0, 1.1));
  EXPECT_FALSE(bands.MayBeVisible(2.5, 4.0));
  EXPECT_TRUE(bands.MayBeVisible(2.5, 4.1));
  EXPECT_TRUE(bands.MayBeVisible(6.0, 7.0));
}
