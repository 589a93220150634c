#include "Viewer/View/MovingImageSize.h"

#include <algorithm>

namespace varimarch
{

namespace
{

constexpr int CoarsestDivisor = 4;
constexpr double FewestPixels = 1 << 18; // fewer would be seen
constexpr double MostPixels = 1 << 21;   // before times are known

// Fractions of the allocated time: an image is to leave the rest to its rays, and the limit for a
// finer one.
constexpr double Most = 0.4;
constexpr double Spare = 0.2;
constexpr double Smallest = 0.5;

// Distances between rays [pixels of the image]: the most that an image is to have, and the limit
// for a finer one, whose rays are at most twice as far apart.
constexpr double MostRayDistance = 2.05;
constexpr double SpareRayDistance = 1.0;

double PixelsOf(const QSize& size, int divisor)
{
  return double(size.width()) * size.height() / (divisor * divisor);
}

}

int MovingImageSize::DivisorFor(const QSize& wanted) const
{
  int used = this->divisor;
  while (used < CoarsestDivisor && PixelsOf(wanted, used) > MostPixels)
  {
    ++used;
  }
  while (used > 1 && PixelsOf(wanted, used) < FewestPixels)
  {
    --used;
  }
  return used;
}

QSize MovingImageSize::Of(const QSize& wanted) const
{
  const int used = this->DivisorFor(wanted);
  return { std::max(wanted.width() / used, 1), std::max(wanted.height() / used, 1) };
}

void MovingImageSize::Took(
  const QSize& wanted, double seconds, double rayDistance, double allocatedSeconds)
{
  const int used = this->DivisorFor(wanted);
  this->otherSeconds = seconds;
  const double finer = used > 1 ? double(used * used) / ((used - 1) * (used - 1)) : 1.0;
  if (seconds > Most * allocatedSeconds || rayDistance > MostRayDistance)
  {
    this->divisor = std::min(used + 1, CoarsestDivisor);
  }
  else if (seconds * finer < Spare * allocatedSeconds && rayDistance <= SpareRayDistance)
  {
    this->divisor = std::max(used - 1, 1);
  }
}

double MovingImageSize::SecondsForRays(double allocatedSeconds) const
{
  return std::max(allocatedSeconds - this->otherSeconds, Smallest * allocatedSeconds);
}

}
