// Guesses at the layout of raw files from their names and sizes.

#include "Scene/Volumes/RawGuess.h"

#include <gtest/gtest.h>

using namespace varimarch;

namespace
{

using Sides = std::array<int, 3>;

}

TEST(RawGuess, RecognizesRawFilesByTheExtension)
{
  for (const char* const path : { "head.raw", "a.b/HEAD.RAW", "head.raw.gz" })
  {
    EXPECT_TRUE(IsBareVoxels(path)) << path;
  }
  for (const char* const path : { "head.nrrd", "raw", "head.raw/slice", "head.raw.nii" })
  {
    EXPECT_FALSE(IsBareVoxels(path)) << path;
  }
}

TEST(RawGuess, TakesTheLayoutFromTheName)
{
  const RawLayout layout = GuessedRawLayout("/data/bonsai_256x128x64_uint16.raw", 1);
  EXPECT_EQ(layout.dimensions, (Sides{ 256, 128, 64 }));
  EXPECT_EQ(layout.type, "uint16");
  EXPECT_EQ(GuessedRawLayout("a_2x3x4.raw", 24).type, "uint8");
  EXPECT_EQ(GuessedRawLayout("a_2x3x4.raw", 48).type, "int16") << "by its size";
}

TEST(RawGuess, InterpretsTheSizeAsACubeOrAsSquareSlices)
{
  EXPECT_EQ(GuessedRawLayout("a.raw", 64 * 64 * 64).dimensions, (Sides{ 64, 64, 64 }));
  EXPECT_EQ(GuessedRawLayout("a.raw", 2 * 125).type, "int16");
  EXPECT_EQ(GuessedRawLayout("a.raw", 512 * 512 * 3).dimensions, (Sides{ 512, 512, 3 }));
  EXPECT_EQ(
    GuessedRawLayout("a_float32.raw", 4 * 256 * 256 * 5).dimensions, (Sides{ 256, 256, 5 }));
  EXPECT_GE(GuessedRawLayout("odd.raw", 7919).dimensions[2], 1);
}

TEST(RawGuess, CountsTheBytesOfHeaderAndVoxels)
{
  EXPECT_EQ(BytesOf({ { 2, 3, 4 }, "float64", { 1, 1, 1 }, false, 10 }), 202);
  EXPECT_EQ(BytesOf({ { 65536, 65536, 2 }, "uint8" }), std::int64_t(1) << 33);
}
