// Bounds of what the levels of blocks change in the light that reaches others.

#include "Unit/LevelPictures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

using namespace varimarch;

namespace
{

constexpr double ShadowStepError = 0.01;

TEST(LevelBound, HoldsInShadows)
{
  const glm::dvec4 dull(0.1, 0.9, 0.0, 1.0);
  double tightest = 1.0;
  double mostOfLight = 0.0;
  for (unsigned seed = 1; seed <= 12; ++seed)
  {
    ByChance chance(seed);
    LevelPictures pictures(Wave, Foggy(chance.Number(0.1, 0.9)), dull);
    pictures.LightFrom({ chance.Number(-1.0, 1.0), chance.Number(-1.0, 1.0), 0.5 });
    for (int i = 0; i < 3; ++i)
    {
      const BlockLevels levels = chance.Levels(pictures.Looks().Coarse());
      EXPECT_LE(pictures.MostBeyond(levels), ShadowStepError) << "seed " << seed;
      LevelBoundScene unlit = pictures.Scene();
      unlit.lights.clear();
      mostOfLight = std::max(
        mostOfLight, pictures.MostBeyond(pictures.Draw(levels), LevelBounds(unlit, levels)));
      tightest = std::min(tightest,
        LargestOf(LevelBounds(pictures.Scene(), levels)) - pictures.LargestDifference(levels));
    }
  }
  EXPECT_LT(tightest, 0.6) << "every bound is far from the error";
  EXPECT_GT(mostOfLight, ShadowStepError) << "light changes nothing beyond the looks";
}

// Without the bounds of light the same images are beyond the bounds of their levels.
void ExpectBoundsUnder(
  unsigned scenes, const std::function<void(ByChance& chance, LevelPictures& pictures)>& light)
{
  const glm::dvec4 dull(0.1, 0.9, 0.0, 1.0);
  double mostOfLight = 0.0;
  for (unsigned seed = 1; seed <= scenes; ++seed)
  {
    ByChance chance(seed);
    LevelPictures pictures(Wave, Foggy(chance.Number(0.1, 0.9)), dull);
    light(chance, pictures);
    const BlockLevels levels = chance.Levels(pictures.Looks().Coarse());
    EXPECT_LE(pictures.MostBeyond(levels), ShadowStepError) << "seed " << seed;
    LevelBoundScene unlit = pictures.Scene();
    unlit.lights.clear();
    mostOfLight =
      std::max(mostOfLight, pictures.MostBeyond(pictures.Draw(levels), LevelBounds(unlit, levels)));
  }
  EXPECT_GT(mostOfLight, ShadowStepError) << "light changes nothing beyond the looks";
}

TEST(LevelBound, HoldsInShadowsOfALampNearTheVolume)
{
  ExpectBoundsUnder(12,
    [](ByChance& chance, LevelPictures& pictures) {
      pictures.LampAt({ chance.Number(-5.0, 25.0), chance.Number(-5.0, 15.0), 15.0 });
    });
}

// Each sample traces 32 rays.
TEST(LevelBound, HoldsUnderAmbientOcclusion)
{
  ExpectBoundsUnder(1,
    [](ByChance& chance, LevelPictures& pictures)
    { pictures.OccludeWithin(chance.Number(2.0, 4.0)); });
}

TEST(LevelRefinement, KeepsTheToleranceInShadowsOfALampNearTheVolume)
{
  constexpr double Tolerance = 1.0 / 16.0;
  LevelPictures pictures(Wave, Foggy(0.3), glm::dvec4(0.1, 0.9, 0.0, 1.0));
  pictures.LampAt({ 10.0, 5.0, 16.0 });
  BlockLevels levels = pictures.Looks().Begun();
  std::vector<double> bounds(std::size_t(BoundPixels.x * BoundPixels.y), 1.0);
  for (int rounds = 0; rounds < 12 && LargestOf(bounds) > Tolerance; ++rounds)
  {
    Refine(pictures.Scene(), { Tolerance }, levels, bounds);
  }
  EXPECT_LE(LargestOf(bounds), Tolerance);
  EXPECT_LE(pictures.LargestDifference(levels), Tolerance + ShadowStepError);
}

TEST(LevelRefinement, KeepsTheToleranceInShadows)
{
  const glm::dvec4 dull(0.1, 0.9, 0.0, 1.0);
  for (const double opacity : { 0.05, 0.9 })
  {
    for (const double tolerance : { 0.25, 1.0 / 32.0 })
    {
      LevelPictures pictures(Wave, Foggy(opacity), dull);
      pictures.LightFrom({ 1.0, 0.4, -0.3 });
      BlockLevels levels = pictures.Looks().Begun();
      std::vector<double> bounds(std::size_t(BoundPixels.x * BoundPixels.y), 1.0);
      int rounds = 0;
      for (; rounds < 8 && LargestOf(bounds) > tolerance; ++rounds)
      {
        Refine(pictures.Scene(), { tolerance }, levels, bounds);
      }
      EXPECT_LE(LargestOf(bounds), tolerance) << opacity;
      EXPECT_LT(rounds, 4);
      EXPECT_LE(pictures.LargestDifference(levels), tolerance + ShadowStepError) << opacity;
    }
  }
}

// Blocks beside a thin fog have clear and opaque voxels: a bound counts the light of each block on
// a ray in full.
TEST(LevelRefinement, EndsInShadowsOfBlocksThatMayBeClear)
{
  constexpr double Tolerance = 1.0 / 8.0;
  const auto speckles = [](const glm::ivec3& place)
  {
    return place.x < 8 ? 1.0 + std::sin(1.7 * place.x + 0.9 * place.y + 1.3 * place.z)
      : (place.x * 7 + place.y * 13 + place.z * 29) % 11 < 5 ? 0.0
                                                             : 100.0;
  };
  LevelPictures pictures(speckles, Foggy(0.9, 0.0), glm::dvec4(0.1, 0.9, 0.0, 1.0));
  pictures.LightFrom({ -1.0, 0.15, 0.2 });
  BlockLevels levels = pictures.Looks().Begun();
  std::vector<double> bounds(std::size_t(BoundPixels.x * BoundPixels.y), 1.0);
  for (int rounds = 0; rounds < 12 && LargestOf(bounds) > Tolerance; ++rounds)
  {
    Refine(pictures.Scene(), { Tolerance }, levels, bounds);
  }
  EXPECT_LE(LargestOf(bounds), Tolerance);
}

}
