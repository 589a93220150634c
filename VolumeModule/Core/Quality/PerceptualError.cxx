#include "Core/Quality/PerceptualError.h"

#include "Core/Quality/Percentile.h"

#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace varimarch
{

namespace
{

// Linear light from an sRGB channel.
double LinearFromDisplay(double channel)
{
  return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

// The CIE's cube root with its linear segment near 0.
double CompressedLight(double relative)
{
  constexpr double Foot = 6.0 / 29.0;
  return relative > Foot * Foot * Foot ? std::cbrt(relative)
                                       : relative / (3.0 * Foot * Foot) + 4.0 / 29.0;
}

double HueDegrees(double a, double b)
{
  const double hue = glm::degrees(std::atan2(b, a));
  return hue < 0.0 ? hue + 360.0 : hue;
}

// Opposite hues differ by 180 degrees up to rounding, which must not decide on which side their
// mean is.
constexpr double HalfTurnDegrees = 180.0 + 1e-9;

// sqrt(C^7 / (C^7 + 25^7)), a measure of saturation in [0, 1].
double Saturation(double chroma)
{
  const double seventh = std::pow(chroma / 25.0, 7.0);
  return std::sqrt(seventh / (seventh + 1.0));
}

struct Chromatic
{
  double chroma;
  double hueDegrees;
};

// C' and h' of the formula, in which a' is stretched near grey.
Chromatic ChromaticOf(const LabColor& color, double stretch)
{
  const double a = stretch * color.a;
  return { std::hypot(a, color.b), HueDegrees(a, color.b) };
}

// Signed difference and mean of two hues, the shorter way round; both 0 if a colour is grey.
struct HuePair
{
  double difference = 0.0;
  double mean = 0.0;
};

HuePair HuesOf(const Chromatic& first, const Chromatic& second)
{
  const double difference = second.hueDegrees - first.hueDegrees;
  const double sum = first.hueDegrees + second.hueDegrees;
  if (first.chroma * second.chroma == 0.0)
  {
    return { 0.0, sum };
  }
  if (std::abs(difference) <= HalfTurnDegrees)
  {
    return { difference, 0.5 * sum };
  }
  return { difference - std::copysign(360.0, difference),
    0.5 * (sum + (sum < 360.0 ? 360 : -360)) };
}

double HueWeight(double hueDegrees)
{
  const auto cosine = [](double degrees) { return std::cos(glm::radians(degrees)); };
  return 1.0 - 0.17 * cosine(hueDegrees - 30.0) + 0.24 * cosine(2.0 * hueDegrees) +
    0.32 * cosine(3.0 * hueDegrees + 6.0) - 0.20 * cosine(4.0 * hueDegrees - 63.0);
}

double ShownChannel(double value)
{
  // This form of the comparison turns NaN into 0.
  return value > 0.0 ? std::min(value, 1.0) : 0.0;
}

std::array<double, 3> ShownColor(const float* rgba, const std::array<double, 3>& background)
{
  std::array<double, 3> color;
  for (int channel = 0; channel < 3; ++channel)
  {
    color[channel] = ShownChannel(rgba[channel] + (1.0 - rgba[3]) * background[channel]);
  }
  return color;
}

// Luma with the weights of Rec. ITU-R BT.601, as in Wang's program.
double Luma(const std::array<double, 3>& rgb)
{
  return 0.299 * rgb[0] + 0.587 * rgb[1] + 0.114 * rgb[2];
}

/// Numbers in rows.
struct Plane
{
  int width;
  int height;
  std::vector<double> values;

  double At(int x, int y) const { return this->values[std::size_t(y) * this->width + x]; }
};

// Weights of a Gaussian window; their sum is 1.
std::vector<double> WindowWeights(int size)
{
  constexpr double Deviation = 1.5;
  std::vector<double> weights;
  double sum = 0.0;
  for (int i = 0; i < size; ++i)
  {
    const double fromMiddle = i - 0.5 * (size - 1);
    weights.push_back(std::exp(-0.5 * fromMiddle * fromMiddle / (Deviation * Deviation)));
    sum += weights.back();
  }
  for (double& weight : weights)
  {
    weight /= sum;
  }
  return weights;
}

// Applies the window to each row wherever it fits, and transposes the result, so that two calls
// filter both ways.
Plane FilteredAndTransposed(const Plane& plane)
{
  constexpr int WindowSide = 11;
  const std::vector<double> weights = WindowWeights(std::min(WindowSide, plane.width));
  const int places = plane.width - int(weights.size()) + 1;
  Plane result = { plane.height, places, std::vector<double>(std::size_t(places) * plane.height) };
  for (int y = 0; y < plane.height; ++y)
  {
    for (int x = 0; x < places; ++x)
    {
      double mean = 0.0;
      for (std::size_t i = 0; i < weights.size(); ++i)
      {
        mean += weights[i] * plane.At(x + int(i), y);
      }
      result.values[std::size_t(x) * plane.height + y] = mean;
    }
  }
  return result;
}

Plane WindowMeans(const Plane& first, const Plane& second)
{
  Plane product = first;
  for (std::size_t i = 0; i < product.values.size(); ++i)
  {
    product.values[i] *= second.values[i];
  }
  return FilteredAndTransposed(FilteredAndTransposed(product));
}

double StructuralSimilarity(const Plane& image, const Plane& truth)
{
  constexpr double C1 = 0.01 * 0.01;
  constexpr double C2 = 0.03 * 0.03;
  const Plane imageMean = FilteredAndTransposed(FilteredAndTransposed(image));
  const Plane truthMean = FilteredAndTransposed(FilteredAndTransposed(truth));
  const Plane imageSquare = WindowMeans(image, image);
  const Plane truthSquare = WindowMeans(truth, truth);
  const Plane product = WindowMeans(image, truth);
  double sum = 0.0;
  for (std::size_t i = 0; i < product.values.size(); ++i)
  {
    const double a = imageMean.values[i];
    const double b = truthMean.values[i];
    const double variances = imageSquare.values[i] - a * a + truthSquare.values[i] - b * b;
    const double covariance = product.values[i] - a * b;
    sum += (2.0 * a * b + C1) * (2.0 * covariance + C2) / ((a * a + b * b + C1) * (variances + C2));
  }
  return sum / double(product.values.size());
}

}

LabColor LabFromDisplay(const std::array<double, 3>& rgb)
{
  // Rows for X, Y and Z; the sum of a row is that coordinate of white.
  constexpr double XyzFromRgb[3][3] = { { 0.4124, 0.3576, 0.1805 }, { 0.2126, 0.7152, 0.0722 },
    { 0.0193, 0.1192, 0.9505 } };
  std::array<double, 3> compressed;
  for (int row = 0; row < 3; ++row)
  {
    double light = 0.0;
    double white = 0.0;
    for (int channel = 0; channel < 3; ++channel)
    {
      light += XyzFromRgb[row][channel] * LinearFromDisplay(rgb[channel]);
      white += XyzFromRgb[row][channel];
    }
    compressed[row] = CompressedLight(light / white);
  }
  const auto [x, y, z] = compressed;
  return { 116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z) };
}

double ColorDifference(const LabColor& first, const LabColor& second)
{
  const double meanChromaAb = 0.5 * (std::hypot(first.a, first.b) + std::hypot(second.a, second.b));
  const double stretch = 1.0 + 0.5 * (1.0 - Saturation(meanChromaAb));
  const Chromatic one = ChromaticOf(first, stretch);
  const Chromatic two = ChromaticOf(second, stretch);
  const HuePair hues = HuesOf(one, two);

  const double meanChroma = 0.5 * (one.chroma + two.chroma);
  const double fromMiddleGrey = 0.5 * (first.lightness + second.lightness) - 50.0;
  const double lightnessSquare = fromMiddleGrey * fromMiddleGrey;
  const double lightness = (second.lightness - first.lightness) /
    (1.0 + 0.015 * lightnessSquare / std::sqrt(20.0 + lightnessSquare));
  const double chroma = (two.chroma - one.chroma) / (1.0 + 0.045 * meanChroma);
  const double hue = 2.0 * std::sqrt(one.chroma * two.chroma) *
    std::sin(glm::radians(0.5 * hues.difference)) /
    (1.0 + 0.015 * meanChroma * HueWeight(hues.mean));

  // Chroma and hue are not independent among blues.
  const double fromBlue = (hues.mean - 275.0) / 25.0;
  const double turnDegrees = 30.0 * std::exp(-fromBlue * fromBlue);
  const double rotation = -2.0 * Saturation(meanChroma) * std::sin(glm::radians(2.0 * turnDegrees));
  return std::sqrt(lightness * lightness + chroma * chroma + hue * hue + rotation * chroma * hue);
}

PerceptualError ComparePerceived(const DisplayedPair& pair)
{
  if (pair.width < 1 || pair.height < 1)
  {
    throw std::invalid_argument(
      "Perceptual error: the images must have at least one pixel, found " +
      std::to_string(pair.width) + " x " + std::to_string(pair.height));
  }
  const std::size_t pixels = std::size_t(pair.width) * pair.height;
  Plane image = { pair.width, pair.height, std::vector<double>(pixels) };
  Plane truth = image;
  std::vector<double> differences(pixels);
  double sum = 0.0;
  for (std::size_t pixel = 0; pixel < pixels; ++pixel)
  {
    const auto shown = ShownColor(pair.image + 4 * pixel, pair.background);
    const auto right = ShownColor(pair.truth + 4 * pixel, pair.background);
    image.values[pixel] = Luma(shown);
    truth.values[pixel] = Luma(right);
    differences[pixel] = ColorDifference(LabFromDisplay(shown), LabFromDisplay(right));
    sum += differences[pixel];
  }
  return { StructuralSimilarity(image, truth), sum / double(pixels),
    Percentile(std::move(differences), 0.99) };
}

}
