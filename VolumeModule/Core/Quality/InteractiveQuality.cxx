#include "Core/Quality/InteractiveQuality.h"

#include "Core/Quality/ErrorBudget.h"

#include <array>

namespace varimarch
{

namespace
{

struct QualityLevel
{
  PictureQuality quality;
  double cost; ///< cost of a frame, relative to the finest level
};

constexpr double Most = ErrorBudget::MostWhileMoving;
constexpr double Half = Most / 2.0;

// A larger tolerance is less visible than fewer rays, so it comes first. Costs are proportional to
// the number of rays; each doubling of the tolerance saves about a quarter, measured on heads.
const std::array<QualityLevel, 9> levels = { { { { 1.0, 1.0 }, 1.0 }, { { 1.0, Half }, 0.75 },
  { { 1.41, Half }, 0.38 }, { { 2.0, Half }, 0.19 }, { { 2.0, Most }, 0.14 },
  { { 2.83, Most }, 0.07 }, { { 4.0, Most }, 0.035 }, { { 5.66, Most }, 0.0175 },
  { { 8.0, Most }, 0.009 } } };

// Fractions of the allocated time: the target for a frame, and the limit for switching to a finer
// level.
constexpr double Aim = 0.9;
constexpr double Spare = 0.7;
constexpr int PicturesBeforeFiner = 3;

// Number of rays that two cores without a graphics card cast in a tenth of a second.
constexpr double RaysBeforeTimesAreKnown = 1 << 16;

int LevelForPixels(double pixels)
{
  int level = 0;
  const auto raysOf = [pixels](const QualityLevel& of)
  { return pixels / (of.quality.imageSampleDistance * of.quality.imageSampleDistance); };
  while (
    level < InteractiveQuality::CoarsestLevel() && raysOf(levels[level]) > RaysBeforeTimesAreKnown)
  {
    ++level;
  }
  return level;
}

}

int InteractiveQuality::CoarsestLevel()
{
  return int(levels.size()) - 1;
}

double InteractiveQuality::ExpectedSeconds(int other) const
{
  return this->seconds * levels[other].cost / levels[this->level].cost;
}

int InteractiveQuality::LevelInTime(int finest, double allocatedSeconds) const
{
  int inTime = finest;
  while (inTime < CoarsestLevel() && this->ExpectedSeconds(inTime) > Aim * allocatedSeconds)
  {
    ++inTime;
  }
  return inTime;
}

PictureQuality InteractiveQuality::Next(double allocatedSeconds, double pixels)
{
  if (this->levelIsGuessed && this->seconds == 0.0)
  {
    this->level = LevelForPixels(pixels);
  }
  else if (this->levelIsGuessed || this->seconds > allocatedSeconds)
  {
    this->level = this->LevelInTime(this->levelIsGuessed ? 0 : this->level, allocatedSeconds);
    this->levelIsGuessed = false;
    this->picturesWithTimeToSpare = 0;
    this->seconds = 0.0;
  }
  else if (this->level > 0 && this->seconds > 0.0 &&
    this->ExpectedSeconds(this->level - 1) < Spare * allocatedSeconds)
  {
    ++this->picturesWithTimeToSpare;
  }
  else
  {
    this->picturesWithTimeToSpare = 0;
  }
  if (this->picturesWithTimeToSpare >= PicturesBeforeFiner)
  {
    --this->level;
    this->picturesWithTimeToSpare = 0;
    this->seconds = 0.0;
  }
  return levels[this->level].quality;
}

PictureQuality InteractiveQuality::Now(double pixels) const
{
  const bool isUnknown = this->levelIsGuessed && this->seconds == 0.0;
  return levels[isUnknown ? LevelForPixels(pixels) : this->level].quality;
}

void InteractiveQuality::Took(double seconds)
{
  this->seconds = seconds;
}

}
