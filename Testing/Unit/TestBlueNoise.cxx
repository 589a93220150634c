#include "Core/Quality/BlueNoise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <complex>
#include <random>

using namespace varimarch;

namespace
{

// Mean power of the frequencies below a quarter of the highest, without the mean.
double LowFrequencyPower(const std::vector<std::uint16_t>& tile, int size)
{
  const double pi = std::acos(-1.0);
  double power = 0.0;
  int frequencies = 0;
  for (int v = 0; v <= size / 8; ++v)
  {
    for (int u = 0; u <= size / 8; ++u)
    {
      std::complex<double> sum = 0.0;
      for (int i = 0; i < size * size; ++i)
      {
        sum += (tile[i] / 65535.0 - 0.5) *
          std::polar(1.0, 2.0 * pi * (u * (i % size) + v * (i / size)) / size);
      }
      power += u + v > 0 ? std::norm(sum) : 0.0;
      ++frequencies;
    }
  }
  return power / frequencies;
}

}

TEST(BlueNoise, HasEachThresholdOnce)
{
  std::vector<std::uint16_t> tile = BlueNoiseTile(64);
  std::sort(tile.begin(), tile.end());
  for (int rank = 0; rank < 4096; ++rank)
  {
    EXPECT_NEAR(tile[rank], (rank + 0.5) / 4096.0 * 65535.0, 1.0);
  }
}

TEST(BlueNoise, HasHardlyAnyLowFrequencies)
{
  std::vector<std::uint16_t> tile = BlueNoiseTile(32);
  const double blue = LowFrequencyPower(tile, 32);
  std::shuffle(tile.begin(), tile.end(), std::mt19937(3));
  EXPECT_LT(blue, 0.05 * LowFrequencyPower(tile, 32));
}

TEST(BlueNoise, IsTheSameEveryTime)
{
  EXPECT_EQ(BlueNoiseTile(16), BlueNoiseTile(16));
}
