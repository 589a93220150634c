#include "Scene/Volumes/ImageStatistics.h"

#include "Frame/VoxelsOnDisk.h"
#include "Readers/ImageFacts.h"
#include "Scene/Volumes/VolumeColors.h"

#include <vtkArrayDispatch.h>
#include <vtkDataArray.h>
#include <vtkDataArrayRange.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

#include <tbb/blocked_range.h>
#include <tbb/combinable.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace varimarch
{

namespace
{

using Counts = std::vector<std::int64_t>;

constexpr double MostBins = 65536.0;

// vtkImageHistogram is no alternative: it writes outside its bins if a whole slab is infinite.
// Values below `lowest` are left out.
Counts Count(vtkDataArray* scalars, int component, double smallest, double binSpacing,
  std::size_t bins, double lowest)
{
  tbb::combinable<Counts> countsOfThreads([bins] { return Counts(bins, 0); });
  const auto countArray = [&](auto* array)
  {
    const auto tuples = vtk::DataArrayTupleRange(array);
    tbb::parallel_for(tbb::blocked_range<vtkIdType>(0, tuples.size(), 65536),
      [&](const tbb::blocked_range<vtkIdType>& range)
      {
        Counts& counts = countsOfThreads.local();
        for (vtkIdType i = range.begin(); i != range.end(); ++i)
        {
          const double value = double(tuples[i][component]);
          if (value < lowest)
          {
            continue;
          }
          const double bin = (value - smallest) / binSpacing + 0.5;
          // The comparison is false for NaN, which therefore falls into the first bin.
          ++counts[bin > 0.0 ? std::size_t(std::min(bin, double(bins - 1))) : 0];
        }
      });
  };
  if (!vtkArrayDispatch::Dispatch::Execute(scalars, countArray))
  {
    countArray(scalars);
  }
  Counts sums(bins, 0);
  countsOfThreads.combine_each([&](const Counts& counts)
    { std::transform(sums.begin(), sums.end(), counts.begin(), sums.begin(), std::plus<>()); });
  return sums;
}

}

ImageStatistics::ImageStatistics(vtkImageData* image)
  : ImageStatistics(
      ColoredVoxels(image), HoldsColors(image) ? AlphaComponent : 0) // alive until it is counted
{
  this->channels = ChannelsIn(image);
  for (std::size_t i = 1; i < this->channels.size(); ++i)
  {
    this->further.push_back(ImageStatistics(image, int(i)));
  }
  this->lengthFactor = varimarch::LengthFactor(image, this->smallest);
}

ImageStatistics::ImageStatistics(vtkImageData* image, int component)
{
  vtkDataArray* const scalars = image->GetPointData()->GetScalars();
  ValueCounts onDisk = CountsOnDisk(scalars);
  if (!onDisk.counts.empty())
  {
    this->smallest = onDisk.smallest;
    this->largest = onDisk.smallest + double(onDisk.counts.size()) - 1.0;
    this->binSpacing = 1.0;
    this->counts = std::move(onDisk.counts);
    return;
  }
  double range[2];
  scalars->GetFiniteRange(range, component);
  const double lowest = LowestInside(image).value_or(-std::numeric_limits<double>::infinity());
  this->smallest = lowest <= range[1] ? std::max(lowest, range[0]) : range[0];
  this->largest = range[1];

  // Integers get one bin each if their range is small enough. A bin is centred on its value.
  const double width = this->largest - this->smallest;
  const int type = image->GetScalarType();
  const bool oneByOne = type != VTK_FLOAT && type != VTK_DOUBLE && width < MostBins;
  const double bins = oneByOne ? width + 1.0 : width > 0.0 ? MostBins : 1.0;
  this->binSpacing = bins > 1.0 ? width / (bins - 1.0) : 1.0;

  this->counts =
    Count(scalars, component, this->smallest, this->binSpacing, std::size_t(bins), lowest);
}

void ImageStatistics::Add(const ImageStatistics& other)
{
  const double least = std::min(this->smallest, other.smallest);
  const double most = std::max(this->largest, other.largest);
  const double width = most - least;
  const bool oneByOne = this->binSpacing == 1.0 && other.binSpacing == 1.0 && width < MostBins;
  const double bins = oneByOne ? std::floor(width) + 1.0 : MostBins;
  const double spacing = bins > 1.0 ? width / (bins - 1.0) : 1.0;
  std::vector<std::int64_t> sums(std::size_t(bins), 0);
  for (const ImageStatistics* const one : { static_cast<const ImageStatistics*>(this), &other })
  {
    for (std::size_t bin = 0; bin < one->counts.size(); ++bin)
    {
      const double place = (one->ValueOfBin(bin) - least) / spacing + 0.5;
      // The comparison is false for a range that is too wide for a number.
      sums[place > 0.0 ? std::size_t(std::min(place, bins - 1.0)) : 0] += one->counts[bin];
    }
  }
  this->smallest = least;
  this->largest = most;
  this->binSpacing = spacing;
  this->counts = std::move(sums);
}

double ImageStatistics::ValueOfBin(std::size_t bin) const
{
  return this->smallest + bin * this->binSpacing;
}

double ImageStatistics::Percentile(double percent) const
{
  std::int64_t total = 0;
  for (const std::int64_t count : this->counts)
  {
    total += count;
  }
  const double wanted = 0.01 * percent * total;
  std::int64_t below = 0;
  std::size_t bin = 0;
  while (bin + 1 < this->counts.size() && below + this->counts[bin] < wanted)
  {
    below += this->counts[bin];
    ++bin;
  }
  return this->ValueOfBin(bin);
}

std::vector<std::int64_t> ImageStatistics::Histogram(int bins) const
{
  std::vector<std::int64_t> sums(bins, 0);
  const double width = this->largest > this->smallest ? this->largest - this->smallest : 1.0;
  for (std::size_t bin = 0; bin < this->counts.size(); ++bin)
  {
    const double position = (this->ValueOfBin(bin) - this->smallest) / width;
    sums[std::min(int(position * bins), bins - 1)] += this->counts[bin];
  }
  return sums;
}

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

namespace
{

constexpr double SmallestPartMm = 20.0;
constexpr double LargestBodyMm = 3000.0;

// A voxel is a box about its centre, so that a single slice has a thickness.
std::array<double, 3> SidesMm(vtkImageData* image)
{
  std::array<double, 3> sides;
  for (int axis = 0; axis < 3; ++axis)
  {
    sides[axis] = image->GetDimensions()[axis] * std::abs(image->GetSpacing()[axis]);
  }
  return sides;
}

}

bool HasSizeOfPatient(vtkImageData* image, double smallestValue)
{
  const std::array<double, 3> sides = SidesMm(image);
  const double longest = *std::max_element(sides.begin(), sides.end());
  return longest >= SmallestPartMm && longest <= LargestBodyMm &&
    (ShowsPatient(image) || smallestValue <= HighestAirHu);
}

double LengthFactor(vtkImageData* image, double smallestValue)
{
  const std::array<double, 3> sides = SidesMm(image);
  const double side = std::cbrt(sides[0]) * std::cbrt(sides[1]) * std::cbrt(sides[2]);
  const bool isKnown = HasSizeOfPatient(image, smallestValue) || !(side > 0.0);
  return isKnown ? 1.0 : side / BodySideMm;
}

}
