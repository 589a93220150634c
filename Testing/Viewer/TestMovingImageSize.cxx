// The size of images while the view moves: large views keep their rate.

#include "Viewer/View/PictureThread.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace varimarch;

namespace
{

constexpr double AllocatedSeconds = 1.0 / 15.0;
const QSize Screen(3840, 2160);

// Draws images of a view on a machine that needs a time for each pixel.
QSize After(MovingImageSize& size, const QSize& wanted, int images, double secondsPerPixel,
  double raysPerImage = 1e9)
{
  for (int i = 0; i < images; ++i)
  {
    const QSize drawn = size.Of(wanted);
    const double pixels = double(drawn.width()) * drawn.height();
    const double rayDistance = std::max(std::sqrt(pixels / raysPerImage), 1.0);
    size.Took(wanted, secondsPerPixel * pixels, rayDistance, AllocatedSeconds);
  }
  return size.Of(wanted);
}

}

TEST(MovingImageSize, OfASmallViewIsThatOfTheView)
{
  MovingImageSize size;
  const QSize small(600, 500);
  EXPECT_EQ(size.Of(small), small);
  EXPECT_EQ(After(size, small, 20, 1e-6), small) << "however slow the machine is";
}

TEST(MovingImageSize, ShrinksUntilItsPixelsAreInTimeAndStays)
{
  constexpr double SecondsPerPixel = 40e-9;
  MovingImageSize size;
  const QSize found = After(size, Screen, 10, SecondsPerPixel);
  EXPECT_LT(SecondsPerPixel * found.width() * found.height(), 0.5 * AllocatedSeconds);
  EXPECT_EQ(found, Screen / 4);
  for (int i = 0; i < 20; ++i)
  {
    EXPECT_EQ(After(size, Screen, 1, SecondsPerPixel), found) << "it flickers";
  }
}

TEST(MovingImageSize, GrowsWhenThereIsTimeToSpare)
{
  MovingImageSize size;
  ASSERT_EQ(After(size, Screen, 10, 40e-9), Screen / 4);
  EXPECT_EQ(After(size, Screen, 10, 2e-9), Screen / 2);
}

TEST(MovingImageSize, ShrinksUntilItsRaysAreClose)
{
  constexpr double SecondsPerPixel = 1e-9;
  MovingImageSize size;
  EXPECT_EQ(After(size, Screen, 10, SecondsPerPixel, 2e5), Screen / 4);
  const QSize found = After(size, Screen, 10, SecondsPerPixel, 6e5);
  EXPECT_EQ(found, Screen / 3);
  for (int i = 0; i < 20; ++i)
  {
    EXPECT_EQ(After(size, Screen, 1, SecondsPerPixel, 6e5), found) << "it flickers";
  }
  EXPECT_EQ(After(size, Screen, 10, SecondsPerPixel), Screen / 2) << "there is time for all rays";
}

TEST(MovingImageSize, LeavesTheRestOfTheTimeToTheRays)
{
  MovingImageSize size;
  EXPECT_EQ(size.SecondsForRays(AllocatedSeconds), AllocatedSeconds);
  size.Took(Screen, 0.01, 1.0, AllocatedSeconds);
  EXPECT_DOUBLE_EQ(size.SecondsForRays(AllocatedSeconds), AllocatedSeconds - 0.01);
  size.Took(Screen, 10.0, 1.0, AllocatedSeconds);
  EXPECT_DOUBLE_EQ(size.SecondsForRays(AllocatedSeconds), 0.5 * AllocatedSeconds);
}
