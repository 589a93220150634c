#include "Core/PictureStrips.h"

#include <algorithm>

namespace varimarch
{

namespace
{

// What a picture is divided into while nothing is known of its time.
constexpr int FirstStrips = 16;

// A strip may be all background, and the next one all bone.
constexpr double MostChange = 4.0;

constexpr int FewestRows = 4;

}

PictureStrips::Rows PictureStrips::Next(int pictureRows, double longestSeconds) const
{
  const int left = pictureRows - this->done;
  if (longestSeconds <= 0.0)
  {
    return { this->done, left };
  }
  const int wanted = this->rows > 0 ? this->rows : pictureRows / FirstStrips;
  return { this->done, std::clamp(wanted, std::min(FewestRows, left), left) };
}

void PictureStrips::Took(const Rows& strip, double seconds, double longestSeconds)
{
  this->done = strip.begin + strip.count;
  if (longestSeconds > 0.0)
  {
    const double change = longestSeconds / std::max(seconds, 1e-6);
    this->rows =
      std::max(int(strip.count * std::clamp(change, 1.0 / MostChange, MostChange)), FewestRows);
  }
}

bool PictureStrips::IsDivided(int pictureRows) const
{
  return this->rows < pictureRows;
}

}
