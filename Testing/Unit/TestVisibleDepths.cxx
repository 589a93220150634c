#include "Core/Fields/VisibleBricks.h"

#include "Core/Geometry/PixelRays.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <gtest/gtest.h>

#include <random>

using namespace varimarch;

namespace
{

constexpr int Width = 101;
constexpr int Height = 67;
constexpr float BlockSide = 6.0f;
const glm::ivec2 SizePixels(Width, Height);

glm::vec3 DirectionOf(const glm::dmat4& clipFromGrid)
{
  const Box box{ glm::dvec3(0.0), glm::dvec3(100.0) };
  return ComputePixelRays(clipFromGrid, box).directionGrid[0];
}

VisibleBlocks RandomBlocks(unsigned seed, int count = 12)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> place(20.0f, 80.0f);
  VisibleBlocks blocks{ BlockSide, {} };
  for (int i = 0; i < count; ++i)
  {
    const float x = place(random);
    const float y = place(random);
    blocks.centersGrid.emplace_back(x, y, place(random));
  }
  return blocks;
}

glm::dmat4 Perspective()
{
  return glm::perspective(0.7, double(Width) / Height, 10.0, 500.0) *
    glm::lookAt(glm::dvec3(-90.0, 20.0, 130.0), glm::dvec3(50.0), glm::dvec3(0.0, 1.0, 0.0));
}

glm::dmat4 Parallel()
{
  return glm::ortho(-90.0, 90.0, -60.0, 60.0, 10.0, 500.0) *
    glm::lookAt(glm::dvec3(-90.0, 20.0, 130.0), glm::dvec3(50.0), glm::dvec3(0.0, 1.0, 0.0));
}

glm::ivec2 PixelOf(const glm::dmat4& clipFromGrid, const glm::dvec3& position)
{
  const glm::dvec4 clip = clipFromGrid * glm::dvec4(position, 1.0);
  return glm::ivec2((glm::dvec2(clip) / clip.w * 0.5 + 0.5) * glm::dvec2(Width, Height));
}

class VisibleDepthsOf : public testing::TestWithParam<bool>
{
};

}

TEST_P(VisibleDepthsOf, HoldAllPointsOfTheBlocks)
{
  const glm::dmat4 clipFromGrid = GetParam() ? Parallel() : Perspective();
  const Viewport pixels{ 3, 5, Width - 10, Height - 9 };
  const VisibleBlocks blocks = RandomBlocks(3);
  VisibleDepths visible;
  const PacketDepths depths =
    visible.Draw(blocks, clipFromGrid, DirectionOf(clipFromGrid), SizePixels, pixels);
  ASSERT_TRUE(depths.nearest);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> within(-0.5 * BlockSide, 0.5 * BlockSide);
  int seen = 0;
  for (int i = 0; i < 4000; ++i)
  {
    const glm::dvec3 position = glm::dvec3(blocks.centersGrid[i % blocks.centersGrid.size()]) +
      glm::dvec3(within(random), within(random), within(random));
    const glm::ivec2 pixel = PixelOf(clipFromGrid, position);
    const bool isDrawn = pixel.x >= pixels.left && pixel.x < pixels.left + pixels.width &&
      pixel.y >= pixels.bottom && pixel.y < pixels.bottom + pixels.height;
    if (!isDrawn)
    {
      continue;
    }
    ++seen;
    const int packet = (pixel.y - depths.bottom) / PacketHeight * depths.columns +
      (pixel.x - depths.left) / PacketWidth;
    const double depth = glm::dot(glm::dvec3(depths.axisGrid), position);
    EXPECT_LE(depths.nearest[packet], depth + 1e-3);
    EXPECT_GE(depths.farthest[packet], depth - 1e-3);
  }
  EXPECT_GT(seen, 1000);
}

TEST_P(VisibleDepthsOf, AreNothingWhereNoBlockIs)
{
  const glm::dmat4 clipFromGrid = GetParam() ? Parallel() : Perspective();
  const Viewport pixels{ 0, 0, Width, Height };
  const VisibleBlocks blocks{ BlockSide, { glm::vec3(50.0f) } };
  VisibleDepths visible;
  const PacketDepths depths =
    visible.Draw(blocks, clipFromGrid, DirectionOf(clipFromGrid), SizePixels, pixels);
  const int middle = Height / 2 / PacketHeight * depths.columns + Width / 2 / PacketWidth;
  EXPECT_LT(depths.nearest[middle], depths.farthest[middle]);
  EXPECT_LT(depths.farthest[middle] - depths.nearest[middle], 2.0f * BlockSide);
  int empty = 0;
  const int packets = depths.columns * ((Height + PacketHeight - 1) / PacketHeight);
  for (int packet = 0; packet < packets; ++packet)
  {
    empty += depths.nearest[packet] > depths.farthest[packet] ? 1 : 0;
  }
  EXPECT_GT(empty, packets * 9 / 10);
}

// Many blocks are drawn by several threads, a single block by one.
TEST_P(VisibleDepthsOf, ManyBlocksAreThoseOfEach)
{
  const glm::dmat4 clipFromGrid = GetParam() ? Parallel() : Perspective();
  const glm::vec3 direction = DirectionOf(clipFromGrid);
  const Viewport pixels{ 0, 0, Width, Height };
  const VisibleBlocks blocks = RandomBlocks(5, 200000);
  VisibleDepths visible;
  const PacketDepths all = visible.Draw(blocks, clipFromGrid, direction, SizePixels, pixels);
  const int packets = all.columns * ((Height + PacketHeight - 1) / PacketHeight);
  VisibleDepths alone;
  for (std::size_t first = 0; first < blocks.centersGrid.size(); first += 500)
  {
    const PacketDepths one = alone.Draw(
      { BlockSide, { blocks.centersGrid[first] } }, clipFromGrid, direction, SizePixels, pixels);
    for (int packet = 0; packet < packets; ++packet)
    {
      ASSERT_LE(all.nearest[packet], one.nearest[packet]);
      ASSERT_GE(all.farthest[packet], one.farthest[packet]);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Projections, VisibleDepthsOf, testing::Bool());

// A block beside the eye may cover any pixel.
TEST(VisibleDepths, SayNothingBesideTheEye)
{
  const glm::dmat4 clipFromGrid = Perspective();
  const VisibleBlocks blocks{ BlockSide, { glm::vec3(50.0f), glm::vec3(-90.0f, 20.0f, 130.0f) } };
  VisibleDepths visible;
  EXPECT_FALSE(
    visible
      .Draw(blocks, clipFromGrid, DirectionOf(clipFromGrid), SizePixels, { 0, 0, Width, Height })
      .nearest);
}

TEST(VisibleDepths, KeepNothingOfWhatWasDrawnBefore)
{
  const glm::dmat4 clipFromGrid = Perspective();
  const glm::vec3 direction = DirectionOf(clipFromGrid);
  const VisibleBlocks block{ BlockSide, { glm::vec3(50.0f) } };
  VisibleDepths visible;
  visible.Draw(
    RandomBlocks(5, 20000), clipFromGrid, direction, SizePixels, { 0, 0, Width, Height });
  visible.Draw({ BlockSide, { glm::vec3(-90.0f, 20.0f, 130.0f) } }, clipFromGrid, direction,
    SizePixels, { 0, 0, Width, Height }); // beside the eye
  const Viewport pixels{ 0, 0, Width / 2, Height / 2 };
  const PacketDepths again = visible.Draw(block, clipFromGrid, direction, SizePixels, pixels);
  VisibleDepths other;
  const PacketDepths first = other.Draw(block, clipFromGrid, direction, SizePixels, pixels);
  ASSERT_TRUE(again.nearest);
  ASSERT_EQ(again.columns, first.columns);
  const int packets = first.columns * ((Height / 2 + PacketHeight - 1) / PacketHeight);
  for (int packet = 0; packet < packets; ++packet)
  {
    ASSERT_EQ(again.nearest[packet], first.nearest[packet]);
    ASSERT_EQ(again.farthest[packet], first.farthest[packet]);
  }
}
