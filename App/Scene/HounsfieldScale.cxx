#include "Scene/HounsfieldScale.h"

#include "Scene/ImageStatistics.h"

#include <cstdint>
#include <numeric>
#include <vector>

namespace varimarch
{

namespace
{

constexpr double AirHu = -1000.0;
constexpr double MuscleHu = 40.0;
constexpr double CompactBoneHu = 1200.0;
constexpr double LeastBoneHu = 300.0;

constexpr int HistogramBins = 256;
constexpr double PercentUpToMuscle = 60.0;
constexpr double PercentUpToBone = 99.5;

// A volume with a smaller body, such as a subtracted angiography, has no soft tissue.
constexpr double LeastBody = 0.02;

// Bone is 1160 HU above muscle, and muscle 1040 HU above air. The distances of other materials, and
// of an MR's tissues, differ more.
constexpr double LeastRatio = 0.3;
constexpr double LargestRatio = 4.0;

// If more of the body has the largest value, a window has cut off the values of bone.
constexpr double MostOfLargestValue = 0.03;

// The number of the first bins that Otsu's threshold parts from the others.
int BinsOfAir(const std::vector<std::int64_t>& bins)
{
  double all = 0.0;
  double allMoments = 0.0;
  for (int i = 0; i < HistogramBins; ++i)
  {
    all += double(bins[i]);
    allMoments += double(i) * double(bins[i]);
  }
  double below = 0.0;
  double moments = 0.0;
  double largestVariance = 0.0;
  int best = 0;
  for (int i = 0; i + 1 < HistogramBins; ++i)
  {
    below += double(bins[i]);
    moments += double(i) * double(bins[i]);
    const double difference = allMoments * below - moments * all;
    const double weights = below * (all - below);
    const double variance = weights > 0.0 ? difference * difference / weights : 0.0;
    if (variance > largestVariance)
    {
      largestVariance = variance;
      best = i + 1;
    }
  }
  return best;
}

}

double HounsfieldScale::ValueAt(double hounsfield) const
{
  const int first = hounsfield < this->marks[1].hounsfield ? 0 : 1;
  const Mark& a = this->marks[first];
  const Mark& b = this->marks[first + 1];
  return a.value +
    (hounsfield - a.hounsfield) * (b.value - a.value) / (b.hounsfield - a.hounsfield);
}

double HounsfieldScale::Factor() const
{
  const auto& [air, muscle, bone] = this->marks;
  return (bone.value - air.value) / (bone.hounsfield - air.hounsfield);
}

bool MayBeHounsfieldUnits(const ImageStatistics& statistics)
{
  return statistics.Smallest() < 0.0;
}

std::optional<HounsfieldScale> EstimatedHounsfieldScale(const ImageStatistics& statistics)
{
  const std::vector<std::int64_t> bins = statistics.Histogram(HistogramBins);
  const double all = double(std::accumulate(bins.begin(), bins.end(), std::int64_t(0)));
  const double airs =
    double(std::accumulate(bins.begin(), bins.begin() + BinsOfAir(bins), std::int64_t(0)));
  const double body = all - airs;
  if (airs == 0.0 || body < LeastBody * all)
  {
    return std::nullopt;
  }
  const auto percentileOfBody = [&](double percent)
  { return statistics.Percentile(100.0 * (airs + 0.01 * percent * body) / all); };
  const double air = statistics.Percentile(50.0 * airs / all);
  const double muscle = percentileOfBody(PercentUpToMuscle);
  const double bone = percentileOfBody(PercentUpToBone);
  const bool isInOrder = air < muscle && bone - muscle > LeastRatio * (muscle - air) &&
    bone - muscle < LargestRatio * (muscle - air);
  if (!isInOrder)
  {
    return std::nullopt;
  }
  const bool isCutOff = double(statistics.Counts().back()) > MostOfLargestValue * body;
  return HounsfieldScale(
    { { { AirHu, air }, { MuscleHu, muscle }, { isCutOff ? LeastBoneHu : CompactBoneHu, bone } } });
}

}
