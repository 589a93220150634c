#include "Core/Blocks/BlockPartition.h"

#include <gtest/gtest.h>

#include <stdexcept>

using namespace varimarch;

namespace
{

// Draws an image from blocks of one byte; returns the number of uploads.
int Uploads(BlockResidency& residency, const std::vector<int>& order, std::size_t capacity)
{
  int uploads = 0;
  residency.BeginPicture(order);
  for (int block : order)
  {
    uploads += !residency.Holds(block);
    residency.Use(block, 1, capacity);
    EXPECT_LE(residency.Bytes(), capacity);
    EXPECT_TRUE(residency.Holds(block));
  }
  return uploads;
}

const std::vector<int> Eight = { 0, 1, 2, 3, 4, 5, 6, 7 };

}

TEST(BlockResidency, BlocksThatFitAreUploadedOnce)
{
  BlockResidency residency;
  EXPECT_EQ(Uploads(residency, Eight, 8), 8);
  EXPECT_EQ(Uploads(residency, Eight, 8), 0);
  EXPECT_EQ(Uploads(residency, { 7, 6, 0 }, 8), 0);
}

TEST(BlockResidency, TheSameFrameReusesAllButOneOfTheHeldBlocks)
{
  BlockResidency residency;
  Uploads(residency, Eight, 5);
  for (int picture = 0; picture < 4; ++picture)
  {
    EXPECT_LE(Uploads(residency, Eight, 5), 8 - 5 + 1);
  }
}

TEST(BlockResidency, BlocksOutsideTheFrameAreEvictedFirstTheLeastRecentlyUsedBeforeOthers)
{
  BlockResidency residency;
  Uploads(residency, { 1, 2, 3 }, 4);
  Uploads(residency, { 2 }, 4);
  residency.BeginPicture({ 2, 4, 5 });
  EXPECT_TRUE(residency.Use(2, 1, 4).empty());
  EXPECT_TRUE(residency.Use(4, 1, 4).empty());
  EXPECT_EQ(residency.Use(5, 1, 4), std::vector<int>{ 1 });
  EXPECT_EQ(residency.Shrink(3), std::vector<int>{ 3 });
}

TEST(BlockResidency, ABlockLargerThanTheMemoryIsRefused)
{
  BlockResidency residency;
  residency.BeginPicture({ 0 });
  EXPECT_THROW(residency.Use(0, 5, 4), std::runtime_error);
}
