#include "Frame/FrameMeasures.h"

#include "Core/Recipe/MaterialRecipe.h"

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
    // Its loops have no limit, but with more samples rounding would decide where samples lie.
    constexpr double TimesAsMany = 4.0;
    return sumMm / TimesAsMany;
  }
  // Iterations of a shader's loops per segment: three for one volume; for several volumes two, plus
  // two for each of them. In a lit volume, the loop that searches for visible samples makes pixels
  // wait for each other: it took five iterations in some images, and may take more in others.
  constexpr double IterationsOfOne = 3.0;
  constexpr double IterationsOfLit = 6.0;
  const bool isLit = MarchesMaterial(frame.settings);
  const double volumes = 1.0 + double(frame.others.size());
  const double iterations =
    volumes > 1.0 ? 2.0 + 2.0 * volumes : (isLit ? IterationsOfLit : IterationsOfOne);
  return sumMm * iterations / IterationsOfOne;
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
