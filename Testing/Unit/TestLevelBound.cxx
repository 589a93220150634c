#include "Core/Quality/LevelBound.h"

#include "Unit/MemorySource.h"
#include "Unit/PacketPictures.h"
#include "Unit/VolumesByChance.h"

#include <glm/gtc/matrix_transform.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

using namespace varimarch;

namespace
{

constexpr glm::ivec2 BoundPixels = glm::ivec2(37, 30);
constexpr double StepError = 1e-3; ///< error of steps and floats

std::vector<std::int16_t> Voxels(const VoxelAt& at)
{
  std::vector<std::int16_t> voxels;
  const glm::ivec3 count = PacketPictures::Dimensions;
  for (int i = 0; i < count.x * count.y * count.z; ++i)
  {
    const double value = at({ i % count.x, i / count.x % count.y, i / count.x / count.y });
    voxels.push_back(std::int16_t(std::lround(std::clamp(value, 0.0, 100.0))));
  }
  return voxels;
}

double Wave(const glm::ivec3& place)
{
  return 50.0 + 45.0 * std::sin(0.25 * place.x) * std::cos(0.2 * place.y);
}

double Ramp(const glm::ivec3& place)
{
  return 10.0 + 4.0 * place.x;
}

TransferFunction Foggy(double opacity, double leastOpacity = 0.01)
{
  return { { { 0.0, { 0.1, 0.2, 0.9 } }, { 100.0, { 1.0, 0.8, 0.2 } } },
    { { 0.0, leastOpacity }, { 100.0, opacity } }, PacketPictures::UnitDistanceMm };
}

TransferFunction Steep()
{
  return { { { 0.0, { 1.0, 1.0, 1.0 } } }, { { 50.0, 0.0 }, { 51.0, 1.0 } },
    PacketPictures::UnitDistanceMm };
}

/// A volume of which each block is drawn by its voxels or by its coarse level.
class LevelPictures
{
public:
  /// @param reflectance  of surfaces under a light at the eye; none without light
  LevelPictures(const VoxelAt& at, const TransferFunction& look,
    const std::optional<glm::dvec4>& reflectance = std::nullopt)
    : pictures({ Voxels(at), look, BoundPixels })
    , summary(SummaryOf(MemorySource<std::int16_t>(
                          VoxelType::Int16, Voxels(at), glm::ivec2(PacketPictures::Dimensions)),
        1 << 20, [](double) {}))
    , looks(this->summary, VoxelType::Int16, this->pictures.Table(),
        reflectance ? std::optional(glm::dot(glm::dvec3(*reflectance), glm::dvec3(1.0)))
                    : std::nullopt)
  {
    if (reflectance)
    {
      this->pictures.LightFromTheEye();
      this->pictures.scene.parameters.reflectances[0] = *reflectance;
      this->pictures.scene.rule = PacketRule::MaterialLinear;
    }
    constexpr double Side = CoarseLevel::Side;
    const glm::dmat4 voxelsFromLevel =
      glm::translate(glm::dmat4(1.0), glm::dvec3(0.5 * (Side - 1.0))) *
      glm::scale(glm::dmat4(1.0), glm::dvec3(Side));
    const glm::dmat3 worldFromLevel = this->pictures.WorldFromGrid() * glm::dmat3(voxelsFromLevel);
    this->level = this->pictures.scene;
    this->level.volume.voxels = this->summary.coarse.voxels.data();
    this->level.volume.voxelCount = this->summary.coarse.voxelCount;
    this->level.parameters.ownGridFromRays = glm::inverse(voxelsFromLevel);
    this->level.parameters.worldFromGrid = worldFromLevel;
    this->level.parameters.worldFromGradient = glm::transpose(glm::inverse(worldFromLevel));
  }

  const BlockLooks& Looks() const { return this->looks; }

  std::vector<float> Draw(const BlockLevels& levels)
  {
    this->pictures.scene.levels = { &this->level, &this->pictures.scene, glm::mat4(1.0f),
      levels.ofBlocks.data(), levels.count, float(levels.side * BrickRanges::CellsPerSide) };
    return this->pictures.March(InstructionSetsOfProcessor().front());
  }

  /// The level without voxels, which ends at its outermost means.
  std::vector<float> DrawAlone()
  {
    RayParameters& rays = this->pictures.scene.rays;
    const RayParameters whole = rays;
    constexpr double Side = CoarseLevel::Side;
    const glm::dvec3 first(0.5 * (Side - 1.0));
    rays.boxLowerGrid = first;
    rays.boxUpperGrid = first + Side * glm::dvec3(this->summary.coarse.voxelCount - 1);
    const std::vector<float> drawn = this->Draw(this->looks.Coarse());
    rays = whole;
    return drawn;
  }

  std::vector<float> DrawVoxels()
  {
    this->pictures.scene.levels = {};
    return this->pictures.March(InstructionSetsOfProcessor().front());
  }

  LevelBoundScene Scene() const
  {
    PixelRays rays = {};
    const RayParameters& from = this->pictures.scene.rays;
    for (int i = 0; i < 3; ++i)
    {
      rays.startGrid[i] = glm::dvec4(glm::vec4(from.rayStartGrid[i]));
      rays.directionGrid[i] = glm::dvec3(glm::vec3(from.rayDirectionGrid[i]));
    }
    rays.nearPlaneGrid = glm::dvec4(glm::vec4(from.nearPlaneGrid));
    rays.farPlaneGrid = glm::dvec4(glm::vec4(from.farPlaneGrid));
    return { this->looks, rays, BoundPixels, this->pictures.WorldFromGrid(),
      { glm::dvec3(0.0), glm::dvec3(PacketPictures::Dimensions - 1) }, false };
  }

  /// The largest difference of a pixel from that of the voxels, less its bound. Colours end at 1,
  /// as they do on a screen.
  double MostBeyond(const BlockLevels& levels)
  {
    return this->MostBeyond(this->Draw(levels), LevelBounds(this->Scene(), levels));
  }

  double MostBeyond(const std::vector<float>& drawn, const std::vector<double>& bounds)
  {
    const std::vector<float> exact = this->DrawVoxels();
    double most = -1.0;
    for (std::size_t i = 0; i < exact.size(); ++i)
    {
      const double difference = std::min(exact[i], 1.0f) - double(std::min(drawn[i], 1.0f));
      most = std::max(most, std::abs(difference) - bounds[i / 4]);
    }
    return most;
  }

  double LargestDifference(const BlockLevels& levels)
  {
    const std::vector<float> exact = this->DrawVoxels();
    const std::vector<float> drawn = this->Draw(levels);
    return std::inner_product(
      exact.begin(), exact.end(), drawn.begin(), 0.0,
      [](double one, double other) { return std::max(one, other); },
      [](float one, float other) { return std::abs(double(one) - double(other)); });
  }

private:
  PacketPictures pictures;
  VolumeSummary summary;
  BlockLooks looks;
  PacketScene level;
};

double LargestOf(const std::vector<double>& bounds)
{
  return *std::max_element(bounds.begin(), bounds.end());
}

/// Refines all pixels.
/// @return the largest bound that is left
double RefineAll(const LevelPictures& pictures, double tolerance, BlockLevels& levels)
{
  std::vector<double> bounds(std::size_t(BoundPixels.x * BoundPixels.y), 1.0);
  Refine(pictures.Scene(), { tolerance }, levels, bounds);
  return LargestOf(bounds);
}

std::ptrdiff_t CountVoxels(const BlockLevels& levels)
{
  return std::count(levels.ofBlocks.begin(), levels.ofBlocks.end(), BlockLevel::Voxels);
}

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
