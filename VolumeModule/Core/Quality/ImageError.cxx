#include "Core/Quality/ImageError.h"

#include "Core/Quality/Percentile.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace varimarch
{

namespace
{

double Difference(float channel, float truth)
{
  const double difference = std::abs(double(channel) - double(truth));
  return std::isfinite(difference) ? difference : std::numeric_limits<double>::infinity();
}

}

ImageError CompareImages(const float* image, const float* truth, std::size_t pixelCount)
{
  if (pixelCount == 0)
  {
    throw std::invalid_argument("Image error: the images must have at least one pixel, found none");
  }
  std::vector<double> errorOfPixel(pixelCount, 0.0);
  double sumOfSquares = 0.0;
  for (std::size_t i = 0; i < 4 * pixelCount; ++i)
  {
    const double difference = Difference(image[i], truth[i]);
    errorOfPixel[i / 4] = std::max(errorOfPixel[i / 4], difference);
    sumOfSquares += difference * difference;
  }
  const double largest = *std::max_element(errorOfPixel.begin(), errorOfPixel.end());
  return { 255.0 * std::sqrt(sumOfSquares / (4.0 * double(pixelCount))),
    255.0 * Percentile(std::move(errorOfPixel), 0.999), 255.0 * largest };
}

}
