#include "Core/Quality/ImageError.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

using namespace varimarch;

namespace
{

ImageError ErrorOf(const std::vector<float>& image, const std::vector<float>& truth)
{
  return CompareImages(image.data(), truth.data(), truth.size() / 4);
}

}

TEST(ImageError, EqualImagesHaveNone)
{
  const std::vector<float> image(400, 0.25f);
  const ImageError error = ErrorOf(image, image);
  EXPECT_EQ(error.rootMeanSquare, 0.0);
  EXPECT_EQ(error.percentile999, 0.0);
  EXPECT_EQ(error.largest, 0.0);
}

TEST(ImageError, CountsInStepsOfAnEightBitDisplay)
{
  const std::vector<float> truth(40, 0.5f);
  std::vector<float> image(truth);
  for (std::size_t i = 0; i < image.size(); ++i)
  {
    image[i] += (i % 2 ? 1.0f : -1.0f) * 2.0f / 255.0f;
  }
  const ImageError error = ErrorOf(image, truth);
  EXPECT_NEAR(error.rootMeanSquare, 2.0, 1e-4);
  EXPECT_NEAR(error.percentile999, 2.0, 1e-4);
  EXPECT_NEAR(error.largest, 2.0, 1e-4);
}

TEST(ImageError, RootMeanSquareWeighsAllChannels)
{
  // One channel of two pixels is off by 1: sqrt(1 / 8).
  const std::vector<float> truth(8, 0.0f);
  EXPECT_NEAR(
    ErrorOf({ 0, 0, 0, 0, 0, 0, 0, 1 }, truth).rootMeanSquare, 255.0 * std::sqrt(1.0 / 8.0), 1e-12);
}

TEST(ImageError, PercentileLeavesOutOnePixelInThousand)
{
  const std::vector<float> truth(4 * 2000, 0.0f);
  std::vector<float> image(truth);
  image[0] = image[1] = image[2] = image[3] = 1.0f;
  image[4] = 0.5f;
  EXPECT_EQ(ErrorOf(image, truth).percentile999, 0.0);
  image[4 * 1999 + 3] = 0.25f;
  EXPECT_EQ(ErrorOf(image, truth).percentile999, 255.0 * 0.25);
  EXPECT_EQ(ErrorOf(image, truth).largest, 255.0);
}

TEST(ImageError, ValuesThatAreNotFiniteAreInfinitelyWrong)
{
  const float infinity = std::numeric_limits<float>::infinity();
  for (const float bad : { std::numeric_limits<float>::quiet_NaN(), infinity, -infinity })
  {
    const ImageError error = ErrorOf({ 0, bad, 0, 0 }, { 0, bad, 0, 0 });
    EXPECT_EQ(error.largest, infinity);
    EXPECT_EQ(error.rootMeanSquare, infinity);
  }
}

TEST(ImageError, NoPixelsAreRefused)
{
  EXPECT_THROW(CompareImages(nullptr, nullptr, 0), std::invalid_argument);
}
