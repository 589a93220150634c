#include "Core/Quality/BlueNoise.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <random>

namespace varimarch
{

namespace
{

// Dots on a tile that repeats endlessly, and how crowded they are around each place.
class DotPattern
{
public:
  explicit DotPattern(int size)
    : size(size)
    , dots(std::size_t(size) * size, false)
    , crowding(dots.size(), 0.0)
    , influence(dots.size())
  {
    constexpr double Radius = 1.5; // radius of a dot's influence, from Ulichney's experiments
    for (int y = 0; y < size; ++y)
    {
      for (int x = 0; x < size; ++x)
      {
        const double dx = std::min(x, size - x);
        const double dy = std::min(y, size - y);
        this->influence[std::size_t(y) * size + x] =
          std::exp(-0.5 * (dx * dx + dy * dy) / (Radius * Radius));
      }
    }
  }

  std::size_t Places() const { return this->dots.size(); }
  bool IsDot(std::size_t place) const { return this->dots[place]; }

  void Set(std::size_t place, bool dot)
  {
    this->dots[place] = dot;
    const int placeX = int(place) % this->size;
    const int placeY = int(place) / this->size;
    for (std::size_t i = 0; i < this->dots.size(); ++i)
    {
      const int x = (int(i) % this->size - placeX) & (this->size - 1);
      const int y = (int(i) / this->size - placeY) & (this->size - 1);
      this->crowding[i] += (dot ? 1.0 : -1.0) * this->influence[std::size_t(y) * this->size + x];
    }
  }

  std::size_t TightestCluster() const { return this->Extreme(true); }
  std::size_t LargestVoid() const { return this->Extreme(false); }

private:
  std::size_t Extreme(bool ofDots) const
  {
    const double sign = ofDots ? 1.0 : -1.0;
    std::size_t found = 0;
    double most = -1e30;
    for (std::size_t i = 0; i < this->dots.size(); ++i)
    {
      if (this->dots[i] == ofDots && sign * this->crowding[i] > most)
      {
        most = sign * this->crowding[i];
        found = i;
      }
    }
    return found;
  }

  int size;
  std::vector<bool> dots;
  std::vector<double> crowding;
  std::vector<double> influence; ///< influence of a dot at the origin
};

// A pattern of dots on a tenth of the places, spread evenly by moving dots from clusters to voids
// until none improves.
DotPattern EvenPattern(int size)
{
  DotPattern pattern(size);
  std::minstd_rand random(1);
  for (std::size_t dots = 0; dots < pattern.Places() / 10; ++dots)
  {
    const std::size_t place = random() % pattern.Places();
    pattern.Set(pattern.IsDot(place) ? pattern.LargestVoid() : place, true);
  }
  for (std::size_t moves = 0; moves < pattern.Places(); ++moves)
  {
    const std::size_t cluster = pattern.TightestCluster();
    pattern.Set(cluster, false);
    const std::size_t hole = pattern.LargestVoid();
    pattern.Set(hole, true);
    if (hole == cluster)
    {
      break;
    }
  }
  return pattern;
}

}

std::vector<std::uint16_t> BlueNoiseTile(int size)
{
  assert(size >= 4 && size <= 64 && (size & (size - 1)) == 0);
  const DotPattern even = EvenPattern(size);
  const std::size_t places = even.Places();
  std::vector<std::uint16_t> tile(places);
  const auto threshold = [places](std::size_t rank)
  { return std::uint16_t((2 * rank + 1) * 65535 / (2 * places)); };

  // The initial dots get the lowest ranks; the most crowded of them the highest of these.
  DotPattern fewer = even;
  const std::size_t dots = places / 10;
  for (std::size_t rank = dots; rank-- > 0;)
  {
    const std::size_t cluster = fewer.TightestCluster();
    fewer.Set(cluster, false);
    tile[cluster] = threshold(rank);
  }
  DotPattern more = even;
  for (std::size_t rank = dots; rank < places; ++rank)
  {
    const std::size_t hole = more.LargestVoid();
    more.Set(hole, true);
    tile[hole] = threshold(rank);
  }
  return tile;
}

}
