#include "Core/Quality/PerceptualError.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

using namespace varimarch;

namespace
{

struct PublishedPair
{
  LabColor first;
  LabColor second;
  double difference;
};

// Table 1 of Sharma et al.
const std::vector<PublishedPair> PublishedPairs = { { { 50.0000, 2.6772, -79.7751 },
                                                      { 50.0000, 0.0000, -82.7485 }, 2.0425 },
  { { 50.0000, 3.1571, -77.2803 }, { 50.0000, 0.0000, -82.7485 }, 2.8615 },
  { { 50.0000, 2.8361, -74.0200 }, { 50.0000, 0.0000, -82.7485 }, 3.4412 },
  { { 50.0000, -1.3802, -84.2814 }, { 50.0000, 0.0000, -82.7485 }, 1.0000 },
  { { 50.0000, -1.1848, -84.8006 }, { 50.0000, 0.0000, -82.7485 }, 1.0000 },
  { { 50.0000, -0.9009, -85.5211 }, { 50.0000, 0.0000, -82.7485 }, 1.0000 },
  { { 50.0000, 0.0000, 0.0000 }, { 50.0000, -1.0000, 2.0000 }, 2.3669 },
  { { 50.0000, -1.0000, 2.0000 }, { 50.0000, 0.0000, 0.0000 }, 2.3669 },
  { { 50.0000, 2.4900, -0.0010 }, { 50.0000, -2.4900, 0.0009 }, 7.1792 },
  { { 50.0000, 2.4900, -0.0010 }, { 50.0000, -2.4900, 0.0010 }, 7.1792 },
  { { 50.0000, 2.4900, -0.0010 }, { 50.0000, -2.4900, 0.0011 }, 7.2195 },
  { { 50.0000, 2.4900, -0.0010 }, { 50.0000, -2.4900, 0.0012 }, 7.2195 },
  { { 50.0000, -0.0010, 2.4900 }, { 50.0000, 0.0009, -2.4900 }, 4.8045 },
  { { 50.0000, -0.0010, 2.4900 }, { 50.0000, 0.0010, -2.4900 }, 4.8045 },
  { { 50.0000, -0.0010, 2.4900 }, { 50.0000, 0.0011, -2.4900 }, 4.7461 },
  { { 50.0000, 2.5000, 0.0000 }, { 50.0000, 0.0000, -2.5000 }, 4.3065 },
  { { 50.0000, 2.5000, 0.0000 }, { 73.0000, 25.0000, -18.0000 }, 27.1492 },
  { { 50.0000, 2.5000, 0.0000 }, { 61.0000, -5.0000, 29.0000 }, 22.8977 },
  { { 50.0000, 2.5000, 0.0000 }, { 56.0000, -27.0000, -3.0000 }, 31.9030 },
  { { 50.0000, 2.5000, 0.0000 }, { 58.0000, 24.0000, 15.0000 }, 19.4535 },
  { { 50.0000, 2.5000, 0.0000 }, { 50.0000, 3.1736, 0.5854 }, 1.0000 },
  { { 50.0000, 2.5000, 0.0000 }, { 50.0000, 3.2972, 0.0000 }, 1.0000 },
  { { 50.0000, 2.5000, 0.0000 }, { 50.0000, 1.8634, 0.5757 }, 1.0000 },
  { { 50.0000, 2.5000, 0.0000 }, { 50.0000, 3.2592, 0.3350 }, 1.0000 },
  { { 60.2574, -34.0099, 36.2677 }, { 60.4626, -34.1751, 39.4387 }, 1.2644 },
  { { 63.0109, -31.0961, -5.8663 }, { 62.8187, -29.7946, -4.0864 }, 1.2630 },
  { { 61.2901, 3.7196, -5.3901 }, { 61.4292, 2.2480, -4.9620 }, 1.8731 },
  { { 35.0831, -44.1164, 3.7933 }, { 35.0232, -40.0716, 1.5901 }, 1.8645 },
  { { 22.7233, 20.0904, -46.6940 }, { 23.0331, 14.9730, -42.5619 }, 2.0373 },
  { { 36.4612, 47.8580, 18.3852 }, { 36.2715, 50.5065, 21.2231 }, 1.4146 },
  { { 90.8027, -2.0831, 1.4410 }, { 91.1528, -1.6435, 0.0447 }, 1.4441 },
  { { 90.9257, -0.5406, -0.9208 }, { 88.6381, -0.8985, -0.7239 }, 1.5381 },
  { { 6.7747, -0.2908, -2.4247 }, { 5.8714, -0.0985, -2.2286 }, 0.6377 },
  { { 2.0776, 0.0795, -1.1350 }, { 0.9033, -0.0636, -0.5514 }, 0.9082 } };

constexpr int WindowSide = 11; // side of one window

// Opaque grey images of the size of one window.
std::vector<float> Grey(double level)
{
  std::vector<float> picture;
  for (int pixel = 0; pixel < WindowSide * WindowSide; ++pixel)
  {
    picture.insert(picture.end(), { float(level), float(level), float(level), 1.0f });
  }
  return picture;
}

PerceptualError Compared(const std::vector<float>& image, const std::vector<float>& truth)
{
  return ComparePerceived(
    { image.data(), truth.data(), WindowSide, WindowSide, { 0.0, 0.0, 0.0 } });
}

}

TEST(ColorDifference, EqualsThePublishedPairsBothWays)
{
  // The table is rounded to four digits.
  for (const PublishedPair& pair : PublishedPairs)
  {
    EXPECT_NEAR(ColorDifference(pair.first, pair.second), pair.difference, 0.5e-4);
    EXPECT_NEAR(ColorDifference(pair.second, pair.first), pair.difference, 0.5e-4);
  }
}

TEST(LabFromDisplay, KnowsTheCornersOfSrgb)
{
  const LabColor white = LabFromDisplay({ 1.0, 1.0, 1.0 });
  EXPECT_NEAR(white.lightness, 100.0, 1e-9);
  EXPECT_NEAR(white.a, 0.0, 1e-9);
  EXPECT_NEAR(white.b, 0.0, 1e-9);
  EXPECT_NEAR(LabFromDisplay({ 0.0, 0.0, 0.0 }).lightness, 0.0, 1e-9);
  // Values of Bruce Lindbloom's calculator, to the digits that the rounded matrix preserves.
  const LabColor red = LabFromDisplay({ 1.0, 0.0, 0.0 });
  EXPECT_NEAR(red.lightness, 53.24, 0.03);
  EXPECT_NEAR(red.a, 80.09, 0.03);
  EXPECT_NEAR(red.b, 67.20, 0.03);
}

TEST(PerceptualError, EqualPicturesHaveNone)
{
  const PerceptualError error = Compared(Grey(0.3), Grey(0.3));
  EXPECT_NEAR(error.structuralSimilarity, 1.0, 1e-12);
  EXPECT_EQ(error.meanColorDifference, 0.0);
  EXPECT_EQ(error.colorDifference99, 0.0);
}

TEST(PerceptualError, FlatPicturesDifferInLuminanceAlone)
{
  // Without structure SSIM is (2 a b + C1) / (a^2 + b^2 + C1); 0.25 and 0.75 are exact in floats.
  const double c1 = 1e-4;
  const double expected = (2.0 * 0.25 * 0.75 + c1) / (0.25 * 0.25 + 0.75 * 0.75 + c1);
  EXPECT_NEAR(Compared(Grey(0.25), Grey(0.75)).structuralSimilarity, expected, 1e-12);
}

TEST(PerceptualError, StructureCountsByItsWeightInTheWindow)
{
  // One white pixel at the centre of a black image: mean w, mean square w, covariance with black 0.
  std::vector<float> dot = Grey(0.0);
  const int middle = 4 * (WindowSide * (WindowSide / 2) + WindowSide / 2);
  dot[middle] = dot[middle + 1] = dot[middle + 2] = 1.0f;
  double sum = 0.0;
  for (int i = -5; i <= 5; ++i)
  {
    sum += std::exp(-i * i / (2.0 * 1.5 * 1.5));
  }
  const double w = 1.0 / (sum * sum);
  const double expected = 1e-4 * 9e-4 / ((w * w + 1e-4) * (w - w * w + 9e-4));
  EXPECT_NEAR(Compared(dot, Grey(0.0)).structuralSimilarity, expected, 1e-12);
}

TEST(PerceptualError, PercentileLeavesOutOnePixelInHundred)
{
  std::vector<float> image = Grey(0.0);
  image[0] = image[1] = image[2] = 1.0f; // one pixel of 121
  const PerceptualError error = Compared(image, Grey(0.0));
  EXPECT_EQ(error.colorDifference99, 0.0);
  EXPECT_NEAR(error.meanColorDifference, 100.0 / 121.0, 1e-9); // distance of white from black: 100
}

TEST(PerceptualError, IsOfThePictureOnItsBackground)
{
  // A transparent image on white equals white on black.
  const std::vector<float> nothing(4 * WindowSide * WindowSide, 0.0f);
  const std::vector<float> white = Grey(1.0);
  const DisplayedPair pair = { nothing.data(), white.data(), WindowSide, WindowSide,
    { 1.0, 1.0, 1.0 } };
  EXPECT_NEAR(ComparePerceived(pair).structuralSimilarity, 1.0, 1e-12);
  EXPECT_EQ(ComparePerceived(pair).meanColorDifference, 0.0);
}

TEST(PerceptualError, IsANumberForAnyPicture)
{
  std::vector<float> bad = Grey(0.5);
  bad[0] = std::numeric_limits<float>::quiet_NaN();
  bad[5] = std::numeric_limits<float>::infinity();
  bad[11] = -std::numeric_limits<float>::infinity();
  const PerceptualError error = Compared(bad, Grey(0.5));
  EXPECT_TRUE(std::isfinite(error.structuralSimilarity));
  EXPECT_TRUE(std::isfinite(error.meanColorDifference));
  const float pixel[4] = { 0.1f, 0.2f, 0.3f, 1.0f };
  EXPECT_NEAR(ComparePerceived({ pixel, pixel, 1, 1, {} }).structuralSimilarity, 1.0, 1e-12);
  EXPECT_THROW(ComparePerceived({ pixel, pixel, 0, 1, {} }), std::invalid_argument);
}
