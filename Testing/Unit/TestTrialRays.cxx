// The rays of trial images: which pixels of an image they belong to.

#include "Core/Quality/TrialRays.h"

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

using namespace varimarch;

namespace
{

constexpr glm::ivec2 UsualTrial(96, 48);

std::vector<glm::ivec2> AllTrialPixels(const glm::ivec2& rays, const glm::ivec2& pixels)
{
  std::vector<glm::ivec2> all;
  for (int y = 0; y < rays.y; ++y)
  {
    for (int x = 0; x < rays.x; ++x)
    {
      all.push_back(TrialPixelOf({ x, y }, rays, pixels));
    }
  }
  return all;
}

}

TEST(TrialRays, OfABlockAreInItsPartOfTheImageAndEquallyFarApart)
{
  const glm::ivec2 block(4, 2);
  for (const glm::ivec2& pixels :
    { UsualTrial, glm::ivec2(97, 49), glm::ivec2(192, 192), glm::ivec2(1921, 1081) })
  {
    const std::vector<glm::ivec2> all = AllTrialPixels(UsualTrial, pixels);
    for (std::size_t i = 0; i < all.size(); ++i)
    {
      const glm::ivec2 ray(int(i) % UsualTrial.x, int(i) / UsualTrial.x);
      const glm::ivec2 corner = ray / block * block;
      const glm::ivec2 first = corner * pixels / UsualTrial;
      const glm::ivec2 behind = (corner + block) * pixels / UsualTrial;
      EXPECT_TRUE(all[i].x >= first.x && all[i].x < behind.x) << pixels.x << ": " << i;
      EXPECT_TRUE(all[i].y >= first.y && all[i].y < behind.y) << pixels.y << ": " << i;
      const glm::ivec2 ofCorner = TrialPixelOf(corner, UsualTrial, pixels);
      const glm::ivec2 apart = TrialPixelOf(corner + 1, UsualTrial, pixels) - ofCorner;
      EXPECT_EQ(all[i], ofCorner + (ray - corner) * apart) << pixels.x << ": " << i;
    }
  }
}

TEST(TrialRays, OfAnImageThatIsTriedWholeAreThoseOfItsPixels)
{
  const glm::ivec2 pixels(57, 31);
  const std::vector<glm::ivec2> all = AllTrialPixels(pixels, pixels);
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    EXPECT_EQ(all[i], glm::ivec2(int(i) % pixels.x, int(i) / pixels.x));
  }
}

// Lines of any direction and period meet as many rays as chance says, within four standard
// deviations of independent blocks of eight equal rays; of rays in a grid, all or none.
TEST(TrialRays, MeetLinesOfAnyPeriodByChance)
{
  const std::vector<glm::ivec2> all = AllTrialPixels(UsualTrial, { 768, 768 });
  for (const glm::ivec2& across : { glm::ivec2(1, 0), glm::ivec2(0, 1), glm::ivec2(1, 1),
         glm::ivec2(1, -1), glm::ivec2(2, 1), glm::ivec2(1, 3) })
  {
    for (int period = 2; period <= 64; ++period)
    {
      for (int phase = 0; phase < period; phase += (period + 3) / 4)
      {
        double met = 0.0;
        for (const glm::ivec2& pixel : all)
        {
          const int place = across.x * pixel.x + across.y * pixel.y + 64 * period * 768;
          met += place % period == phase ? 1.0 : 0.0;
        }
        const double part = 1.0 / period;
        const double deviation = std::sqrt(8.0 * double(all.size()) * part * (1.0 - part));
        EXPECT_NEAR(met, double(all.size()) * part, 4.0 * deviation + 1.0)
          << period << ", " << across.x << ", " << across.y;
      }
    }
  }
}

TEST(TrialRays, OfAListAreOneOfEachOfEqualParts)
{
  EXPECT_EQ(TrialIndices(3, 5), (std::vector<std::size_t>{ 0, 1, 2 }));
  EXPECT_TRUE(TrialIndices(0, 5).empty());
  const std::vector<std::size_t> some = TrialIndices(1000, 100);
  ASSERT_EQ(some.size(), 100U);
  int inMiddle = 0;
  for (std::size_t i = 0; i < some.size(); ++i)
  {
    EXPECT_EQ(some[i] / 10, i);
    inMiddle += some[i] % 10 == 5 ? 1 : 0;
  }
  EXPECT_LT(inMiddle, 30);
}
