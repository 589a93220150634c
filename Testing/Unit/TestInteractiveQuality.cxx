#include "Core/Quality/InteractiveQuality.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

using namespace varimarch;

namespace
{

constexpr double SmallPicture = 256.0 * 256.0;
constexpr double LargePicture = 3840.0 * 2160.0;

// Simulates a machine whose time is proportional to the number of rays, plus a constant.
double SecondsOf(const PictureQuality& quality, double fullSeconds)
{
  return 0.002 + fullSeconds / (quality.imageSampleDistance * quality.imageSampleDistance);
}

// Rendering time of a frame after some others.
double SecondsAfter(InteractiveQuality& quality, int pictures, double allocated, double fullSeconds)
{
  double seconds = 0.0;
  for (int i = 0; i < pictures; ++i)
  {
    seconds = SecondsOf(quality.Next(allocated, SmallPicture), fullSeconds);
    quality.Took(seconds);
  }
  return seconds;
}

}

TEST(InteractiveQuality, StaysFullWhileThereIsTime)
{
  InteractiveQuality quality;
  SecondsAfter(quality, 20, 0.1, 0.05);
  EXPECT_EQ(quality.Level(), 0);
}

TEST(InteractiveQuality, NowIsThatOfTheNextPictureWhileTimesSuffice)
{
  InteractiveQuality quality;
  const PictureQuality guessed = quality.Now(LargePicture);
  EXPECT_GT(guessed.imageSampleDistance, 1.0);
  EXPECT_EQ(quality.Next(0.1, LargePicture).imageSampleDistance, guessed.imageSampleDistance);
  SecondsAfter(quality, 10, 0.1, 0.8);
  const PictureQuality now = quality.Now(SmallPicture);
  EXPECT_GT(now.imageSampleDistance, 1.0);
  EXPECT_EQ(quality.Next(0.1, SmallPicture).imageSampleDistance, now.imageSampleDistance);
}

TEST(InteractiveQuality, IsInTimeAtTheLatestWithTheFifthPicture)
{
  for (double fullSeconds : { 0.15, 0.4, 1.0, 2.0 })
  {
    InteractiveQuality quality;
    EXPECT_LT(SecondsAfter(quality, 5, 0.1, fullSeconds), 0.1) << fullSeconds;
  }
}

TEST(InteractiveQuality, DoesNotFlickerWhereTimesVaryByAFifth)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> noise(0.9, 1.1);
  for (double fullSeconds : { 0.12, 0.2, 0.3, 0.5, 0.9 })
  {
    InteractiveQuality quality;
    SecondsAfter(quality, 30, 0.1, fullSeconds);
    std::set<int> levels;
    for (int i = 0; i < 200; ++i)
    {
      quality.Took(noise(random) * SecondsOf(quality.Next(0.1, SmallPicture), fullSeconds));
      levels.insert(quality.Level());
    }
    EXPECT_LE(levels.size(), 2u) << fullSeconds;
    EXPECT_LE(*levels.rbegin() - *levels.begin(), 1) << fullSeconds;
  }
}

TEST(InteractiveQuality, ComesBackWhereThePictureBecomesEasy)
{
  InteractiveQuality quality;
  SecondsAfter(quality, 10, 0.1, 2.0);
  EXPECT_GT(quality.Level(), 2);
  SecondsAfter(quality, 60, 0.1, 0.03);
  EXPECT_EQ(quality.Level(), 0);
}

TEST(InteractiveQuality, EndsAtTheCoarsestLevelWhereNothingHelps)
{
  InteractiveQuality quality;
  SecondsAfter(quality, 10, 1e-6, 1.0);
  EXPECT_EQ(quality.Level(), InteractiveQuality::CoarsestLevel());
}

TEST(InteractiveQuality, BeginsWithFewRaysWhileNoTimeIsKnown)
{
  InteractiveQuality quality;
  EXPECT_EQ(quality.Next(0.1, SmallPicture).imageSampleDistance, 1.0);
  EXPECT_EQ(quality.Next(0.1, LargePicture).imageSampleDistance, 8.0)
    << "although no change was reported";
}

TEST(InteractiveQuality, IsFullWithTheSecondPictureOfAFastMachine)
{
  InteractiveQuality quality;
  quality.Next(0.1, LargePicture);
  quality.Took(1e-4);
  quality.Next(0.1, LargePicture);
  EXPECT_EQ(quality.Level(), 0);
}
