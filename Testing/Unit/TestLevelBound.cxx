#include "Core/Quality/LevelBound.h"

#include "Unit/PacketPictures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace varimarch;

namespace
{

constexpr glm::ivec2 BoundPixels = glm::ivec2(37, 30);

TransferFunction Foggy(double opacity, double leastOpacity = 0.01)
{
  return { { { 0.0, { 0.1, 0.2, 0.9 } }, { 100.0, { 1.0, 0.8, 0.2 } } },
    { { 0.0, leastOpacity }, { 100.0, opacity } }, PacketPictures::UnitDistanceMm };
}

/// Waves, moved by some voxels along x up to the last one.
std::vector<std::int16_t> Waves(int moved)
{
  std::vector<std::int16_t> voxels;
  const glm::ivec3 count = PacketPictures::Dimensions;
  for (int i = 0; i < count.x * count.y * count.z; ++i)
  {
    const double x = std::min(i % count.x + moved, count.x - 1);
    const double wave = std::sin(0.25 * x) * std::cos(0.2 * (i / count.x % count.y));
    voxels.push_back(std::int16_t(std::lround(50.0 + 45.0 * wave)));
  }
  return voxels;
}

BrickRanges RangesOf(const PacketPictures& pictures)
{
  return BuildBrickRanges(pictures.Grid(), 0.0, 100.0);
}

std::vector<float> BoundsOf(const PacketPictures& pictures, const BrickRanges& ranges)
{
  PixelRays rays = {};
  for (int i = 0; i < 3; ++i)
  {
    rays.startGrid[i] = glm::dvec4(glm::vec4(pictures.scene.rays.rayStartGrid[i]));
    rays.directionGrid[i] = glm::dvec3(glm::vec3(pictures.scene.rays.rayDirectionGrid[i]));
  }
  rays.nearPlaneGrid = glm::dvec4(glm::vec4(pictures.scene.rays.nearPlaneGrid));
  rays.farPlaneGrid = glm::dvec4(glm::vec4(pictures.scene.rays.farPlaneGrid));
  return LevelBounds(
    { ranges, pictures.Table(), rays, BoundPixels, pictures.WorldFromGrid(), false });
}

/// The largest difference of a channel of each pixel, less its bound.
double MostBeyond(const PacketPictures& one, const PacketPictures& other)
{
  const InstructionSet set = InstructionSetsOfProcessor().front();
  const std::vector<float> a = one.March(set);
  const std::vector<float> b = other.March(set);
  const std::vector<float> bounds = BoundsOf(one, RangesOf(one));
  double most = -1.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    most = std::max(most, std::abs(double(a[i]) - b[i]) - bounds[i / 4]);
  }
  return most;
}

// A volume that is moved by a voxel has no value beyond the ranges of bricks and their neighbours.
TEST(LevelBound, HoldsInEveryPixelForValuesWithinTheRanges)
{
  constexpr double RoundOff = 1e-3;
  for (const double opacity : { 0.02, 0.2, 0.9 })
  {
    const PacketPictures one({ Waves(0), Foggy(opacity), BoundPixels });
    const PacketPictures other({ Waves(3), Foggy(opacity), BoundPixels });
    EXPECT_LE(MostBeyond(one, other), RoundOff) << opacity;
  }
}

TEST(LevelBound, IsWholeWhereAnOpaqueSurfaceMayMove)
{
  const TransferFunction steep{ { { 0.0, { 1.0, 1.0, 1.0 } } }, { { 50.0, 0.0 }, { 51.0, 1.0 } },
    PacketPictures::UnitDistanceMm };
  const PacketPictures pictures({ Waves(0), steep, BoundPixels });
  const std::vector<float> bounds = BoundsOf(pictures, RangesOf(pictures));
  EXPECT_GT(*std::max_element(bounds.begin(), bounds.end()), 0.99f);
}

TEST(LevelBound, IsZeroWhereNothingIsSeen)
{
  const PacketPictures pictures({ Waves(0), Foggy(0.0, 0.0), BoundPixels });
  const std::vector<float> bounds = BoundsOf(pictures, RangesOf(pictures));
  EXPECT_EQ(*std::max_element(bounds.begin(), bounds.end()), 0.0f);
}

// Where the level has no value, the eye may see nothing instead of the voxels.
TEST(LevelBound, HoldsForGaps)
{
  const PacketPictures pictures({ Waves(0), Foggy(0.9, 0.9), BoundPixels });
  BrickRanges gaps = RangesOf(pictures);
  const glm::ivec3 count = gaps.BrickCount();
  for (int brick = 0; brick < count.x * count.y * count.z; ++brick)
  {
    gaps.Set(std::size_t(brick), { 1, 0 });
  }
  const std::vector<float> drawn = pictures.March(InstructionSetsOfProcessor().front());
  const std::vector<float> bounds = BoundsOf(pictures, gaps);
  constexpr float RoundOff = 1e-3f;
  for (std::size_t i = 0; i < bounds.size(); ++i)
  {
    EXPECT_GE(bounds[i], drawn[4 * i + 3] - RoundOff) << i;
  }
}

}
