#include "Frame/FrameMeasures.h"

#include "Core/Recipe/ShaderRecipe.h"

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

template <class Number>
double SumOf(const Frame& frame, const Number& numberOf)
{
  double sum = numberOf(frame.geometry);
  for (const Frame& other : frame.others)
  {
    sum += numberOf(other.geometry);
  }
  return sum;
}

template <class Number>
double SmallestOf(const Frame& frame, const Number& numberOf)
{
  double smallest = numberOf(frame.geometry);
  for (const Frame& other : frame.others)
  {
    smallest = std::min(smallest, numberOf(other.geometry));
  }
  return smallest;
}

}

double SmallestSpacingMm(const Frame& frame)
{
  return SmallestOf(
    frame, [](const VolumeGeometry& geometry) { return geometry.SmallestSpacingMm(); });
}

double ThinnestSideMm(const Frame& frame)
{
  return SmallestOf(
    frame, [](const VolumeGeometry& geometry) { return geometry.ThinnestSideMm(); });
}

double LongestRayMm(const Frame& frame)
{
  return SumOf(frame, [](const VolumeGeometry& geometry) { return geometry.DiagonalMm(); });
}

double ShortestSampleDistanceMm(const Frame& frame, Marcher marcher)
{
  const double sumMm = SumOf(
    frame, [](const VolumeGeometry& geometry) { return geometry.ShortestSampleDistanceMm(); });
  if (marcher == Marcher::Processor)
  {
    // Nothing limits its loops, but with more samples rounding would decide where they lie.
    constexpr double TimesAsMany = 4.0;
    return sumMm / TimesAsMany;
  }
  // Rounds of a shader's loops per segment: three for one volume; for several volumes two, and two
  // more for each of them. A lit volume is searched for visible samples by a loop in which pixels
  // wait for each other: that took five rounds in some images, and may take more in others.
  constexpr double RoundsOfOne = 3.0;
  constexpr double RoundsOfLit = 6.0;
  const bool isLit = MarchesMaterial(frame.settings);
  const double volumes = 1.0 + double(frame.others.size());
  const double rounds = volumes > 1.0 ? 2.0 + 2.0 * volumes : (isLit ? RoundsOfLit : RoundsOfOne);
  return sumMm * rounds / RoundsOfOne;
}

int MostSegments(const Frame& frame, double sampleDistanceMm)
{
  int most = int(std::ceil(LongestRayMm(frame) / sampleDistanceMm));
  const auto add = [&](const Frame& one)
  { most += one.geometry.dimensions.x + one.geometry.dimensions.y + one.geometry.dimensions.z; };
  add(frame);
  std::for_each(frame.others.begin(), frame.others.end(), add);
  return most;
}

}
