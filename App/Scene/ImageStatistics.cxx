#include "Scene/ImageStatistics.h"

#include "Frame/VoxelsOnDisk.h"
#include "Readers/ImageFacts.h"
#include "Scene/LengthScale.h"
#include "Scene/VolumeColors.h"

#include <vtkArrayDispatch.h>
#include <vtkDataArray.h>
#include <vtkDataArrayRange.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

#include <tbb/blocked_range.h>
#include <tbb/combinable.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

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

}
