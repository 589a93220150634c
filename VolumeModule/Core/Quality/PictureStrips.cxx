#include "Core/Quality/PictureStrips.h"

#include <algorithm>

namespace varimarch
{

namespace
{

// Number of strips of an image until a time is known.
constexpr int FirstStrips = 16;

// Limits the change from one strip to the next, since one may be all background and the next all
// bone.
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
    // The last strip of an image may be only a few rows, whose time predicts less than earlier
    // ones.
    const double before = this->rows > 0 ? this->rows : strip.count;
    const double inTime = strip.count * longestSeconds / std::max(seconds, 1e-6);
    const double most = std::max(MostChange * strip.count, before);
    this->rows = std::max(int(std::clamp(inTime, before / MostChange, most)), FewestRows);
  }
}

bool PictureStrips::IsDivided(int pictureRows) const
{
  return this->rows < pictureRows;
}

}
