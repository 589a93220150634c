#include "Unit/LevelPictures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

using namespace varimarch;

namespace
{

TEST(LevelBound, HoldsInEveryPixelForAnyLevelsOfBlocks)
{
  double tightest = 1.0;
  for (unsigned seed = 1; seed <= 40; ++seed)
  {
    ByChance chance(seed);
    const VoxelAt volume = chance.Volume();
    const std::vector<std::int16_t> voxels = Voxels(volume);
    const auto at = [&](const glm::ivec3& place)
    {
      const glm::ivec3 count = PacketPictures::Dimensions;
      return double(voxels[std::size_t((place.z * count.y + place.y) * count.x + place.x)]);
    };
    LevelPictures pictures(at, chance.Function());
    for (int i = 0; i < 3; ++i)
    {
      const BlockLevels levels = chance.Levels(pictures.Looks().Coarse());
      EXPECT_LE(pictures.MostBeyond(levels), StepError) << "seed " << seed;
      tightest = std::min(tightest,
        LargestOf(LevelBounds(pictures.Scene(), levels)) - pictures.LargestDifference(levels));
    }
    BlockLevels refined = pictures.Looks().Begun();
    EXPECT_LE(pictures.MostBeyond(refined), StepError) << "seed " << seed;
    RefineAll(pictures, chance.Number(0.02, 0.5), refined);
    EXPECT_LE(pictures.MostBeyond(refined), StepError) << "seed " << seed;
  }
  EXPECT_LT(tightest, 0.05) << "no bound is near an error";
}

// The values of the level between have nothing to do with those of the volume.
TEST(LevelBound, HoldsInEveryPixelForThreeLevels)
{
  double tightest = 1.0;
  for (unsigned seed = 1; seed <= 20; ++seed)
  {
    ByChance chance(seed);
    const VoxelAt volume = chance.Volume();
    const VoxelAt between = chance.Volume();
    LevelPictures pictures(volume, chance.Function(), std::nullopt, between);
    for (int i = 0; i < 3; ++i)
    {
      const BlockLevels levels = chance.Levels(pictures.Looks().Coarse());
      EXPECT_LE(pictures.MostBeyond(levels), StepError) << "seed " << seed;
      tightest = std::min(tightest,
        LargestOf(LevelBounds(pictures.Scene(), levels)) - pictures.LargestDifference(levels));
    }
    BlockLevels refined = pictures.Looks().Begun();
    RefineAll(pictures, chance.Number(0.02, 0.5), refined);
    EXPECT_LE(pictures.MostBeyond(refined), StepError) << "seed " << seed;
  }
  EXPECT_LT(tightest, 0.05) << "no bound is near an error";
}

// The level lacks up to one and a half voxels before, and four and a half behind.
TEST(LevelBound, HoldsForTheLevelAlone)
{
  for (const double opacity : { 0.1, 0.9 })
  {
    LevelPictures pictures([](const glm::ivec3&) { return 60.0; }, Foggy(opacity, opacity));
    LevelBoundScene scene = pictures.Scene();
    scene.endsEarlier = true;
    const std::vector<double> bounds = LevelBounds(scene, pictures.Looks().Coarse());
    EXPECT_LE(pictures.MostBeyond(pictures.DrawAlone(), bounds), StepError) << opacity;
    EXPECT_GT(LargestOf(bounds), 0.0);
  }
}

TEST(LevelBound, HoldsUnderAnyLight)
{
  // The second is shinier than a surface that reflects no more than it receives.
  for (const glm::dvec4& reflectance :
    { glm::dvec4(0.2, 0.7, 0.1, 8.0), glm::dvec4(0.2, 0.7, 4.0, 2.0) })
  {
    LevelPictures pictures(Wave, Foggy(0.4), reflectance);
    ByChance chance(7);
    for (int i = 0; i < 4; ++i)
    {
      EXPECT_LE(pictures.MostBeyond(chance.Levels(pictures.Looks().Coarse())), 0.01)
        << reflectance.z;
    }
  }
}

TEST(LevelBound, IsZeroForVoxels)
{
  LevelPictures pictures(Wave, Foggy(0.4));
  BlockLevels levels = pictures.Looks().Coarse();
  std::fill(levels.ofBlocks.begin(), levels.ofBlocks.end(), BlockLevel::Voxels);
  EXPECT_EQ(LargestOf(LevelBounds(pictures.Scene(), levels)), 0.0);
  EXPECT_LE(pictures.LargestDifference(levels), StepError);
}

TEST(LevelBound, IsWholeWhereAnOpaqueSurfaceMayMove)
{
  const LevelPictures pictures(Wave, Steep());
  EXPECT_GT(LargestOf(LevelBounds(pictures.Scene(), pictures.Looks().Coarse())), 0.99);
}

TEST(LevelBound, IsZeroWhereNothingIsSeen)
{
  const LevelPictures pictures(Wave, Foggy(0.0, 0.0));
  EXPECT_EQ(LargestOf(LevelBounds(pictures.Scene(), pictures.Looks().Coarse())), 0.0);
}

TEST(LevelRefinement, KeepsTheToleranceInEveryPixel)
{
  for (const double opacity : { 0.02, 0.2, 0.9 })
  {
    for (const double tolerance : { 0.25, 1.0 / 16.0, 1.0 / 128.0 })
    {
      LevelPictures pictures(Wave, Foggy(opacity));
      BlockLevels levels = pictures.Looks().Begun();
      const double bound = RefineAll(pictures, tolerance, levels);
      EXPECT_LE(bound, tolerance);
      EXPECT_LE(LargestOf(LevelBounds(pictures.Scene(), levels)), bound + 1e-6);
      EXPECT_LE(pictures.MostBeyond(levels), StepError);
      EXPECT_LE(pictures.LargestDifference(levels), tolerance + StepError) << opacity;
    }
  }
}

TEST(LevelRefinement, TakesMoreVoxelsForASmallerTolerance)
{
  const LevelPictures pictures(Wave, Foggy(0.02));
  BlockLevels levels = pictures.Looks().Begun();
  std::ptrdiff_t before = 0;
  for (const double tolerance : { 0.06, 0.05, 0.04 })
  {
    RefineAll(pictures, tolerance, levels);
    EXPECT_GT(CountVoxels(levels), before) << tolerance;
    before = CountVoxels(levels);
  }
  EXPECT_LT(before, std::ptrdiff_t(levels.ofBlocks.size()));
}

TEST(LevelRefinement, TakesVoxelsForRowsOfPixelsInSeveralRounds)
{
  constexpr double Tolerance = 1.0 / 128.0;
  LevelPictures pictures(Wave, Foggy(0.2));
  BlockLevels levels = pictures.Looks().Begun();
  std::vector<double> bounds = LevelBounds(pictures.Scene(), levels);
  std::ptrdiff_t before = CountVoxels(levels);
  int rounds = 0;
  while (LargestOf(bounds) > Tolerance)
  {
    Refine(pictures.Scene(), { Tolerance, 1 }, levels, bounds);
    EXPECT_GT(CountVoxels(levels), before);
    EXPECT_LE(pictures.MostBeyond(pictures.Draw(levels), bounds), StepError) << rounds;
    before = CountVoxels(levels);
    ++rounds;
  }
  EXPECT_EQ(rounds, 2) << "each is of 16 rows";
}

// Every second voxel of a slow wave is nearly the wave itself.
TEST(LevelRefinement, TakesTheLevelBetweenWhereThatSuffices)
{
  const auto slow = [](const glm::ivec3& place) { return 50.0 + 40.0 * std::sin(0.15 * place.x); };
  LevelPictures pictures(
    slow, Foggy(0.05), std::nullopt, [&](const glm::ivec3& place) { return slow(2 * place); });
  BlockLevels levels = pictures.Looks().Begun();
  const double bound = RefineAll(pictures, 0.05, levels);
  EXPECT_LE(bound, 0.05);
  EXPECT_LE(pictures.MostBeyond(levels), StepError);
  const auto between =
    std::count(levels.ofBlocks.begin(), levels.ofBlocks.end(), BlockLevel::Coarse);
  EXPECT_GT(between, 0);
  RefineAll(pictures, 1e-9, levels);
  EXPECT_EQ(LargestOf(LevelBounds(pictures.Scene(), levels)), 0.0) << "all are voxels in the end";
}

TEST(LevelRefinement, TakesNoVoxelsOfOneMaterial)
{
  const LevelPictures pictures([](const glm::ivec3&) { return 60.0; }, Foggy(0.3));
  BlockLevels levels = pictures.Looks().Begun();
  constexpr double BetweenTwoEntries = 0.005;
  EXPECT_LE(RefineAll(pictures, 1.0 / 128.0, levels), BetweenTwoEntries);
  EXPECT_EQ(CountVoxels(levels), 0);
}

// The bricks around the middle are opaque, and only those between them have a structure.
TEST(LevelRefinement, TakesNoVoxelsThatAreHidden)
{
  const auto isInside = [](const glm::ivec3& place) {
    return place.x > 4 && place.x < 16 && place.y > 4 && place.y < 8 && place.z > 4 && place.z < 8;
  };
  const LevelPictures pictures([&](const glm::ivec3& place)
    { return isInside(place) ? 100.0 * (place.x % 2) : 100.0; },
    Steep());
  BlockLevels levels = pictures.Looks().Begun();
  RefineAll(pictures, 1.0 / 128.0, levels);
  EXPECT_EQ(levels.ofBlocks[levels.PlaceOf({ 2, 1, 1 })], BlockLevel::Coarse);
}

// Trilinear interpolation between means has a ramp's own values, but for the outermost ones.
TEST(LevelRefinement, HasNoSeamsInARamp)
{
  LevelPictures pictures(Ramp, Foggy(0.3));
  BlockLevels levels = pictures.Looks().Coarse();
  const int count = levels.count.x;
  for (std::size_t place = 0; place < levels.ofBlocks.size(); ++place)
  {
    const int x = int(place) % count;
    levels.ofBlocks[place] =
      x == 0 || x == count - 1 || x % 2 == 0 ? BlockLevel::Voxels : BlockLevel::Coarse;
  }
  ASSERT_LT(CountVoxels(levels), std::ptrdiff_t(levels.ofBlocks.size()));
  EXPECT_LE(pictures.LargestDifference(levels), StepError);
}

}
