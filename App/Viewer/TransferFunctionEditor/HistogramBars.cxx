#include "Viewer/TransferFunctionEditor/HistogramBars.h"

#include <algorithm>
#include <cmath>

namespace varimarch
{

HistogramBars::HistogramBars(const ImageStatistics& statistics, double leastWidth)
  : statistics(&statistics)
  , binsPerBar(std::max<std::int64_t>(1, std::ceil(leastWidth / statistics.BinSpacing())))
{
}

std::vector<HistogramBars::Bar> HistogramBars::Between(double first, double last) const
{
  const double smallest = std::max(first, this->statistics->Smallest());
  const double largest = std::min(last, this->statistics->Largest());
  std::vector<Bar> bars;
  if (smallest > largest)
  {
    return bars;
  }
  for (std::int64_t i = this->IndexOf(smallest); i <= this->IndexOf(largest); ++i)
  {
    bars.push_back(this->BarOfIndex(i));
  }
  return bars;
}

HistogramBars::Bar HistogramBars::At(double value) const
{
  return this->BarOfIndex(this->IndexOf(value));
}

HistogramBars::Bar HistogramBars::BarOfIndex(std::int64_t index) const
{
  // A bin is centred on its value.
  const double spacing = this->statistics->BinSpacing();
  const double width = double(this->binsPerBar) * spacing;
  const double first = this->statistics->Smallest() - 0.5 * spacing + double(index) * width;
  Bar bar{ first, first + width, 0 };
  const std::vector<std::int64_t>& counts = this->statistics->Counts();
  const std::int64_t bins = std::int64_t(counts.size());
  const std::int64_t begin = std::clamp<std::int64_t>(index * this->binsPerBar, 0, bins);
  const std::int64_t end = std::clamp<std::int64_t>((index + 1) * this->binsPerBar, 0, bins);
  for (std::int64_t bin = begin; bin < end; ++bin)
  {
    bar.count += counts[bin];
  }
  return bar;
}

std::int64_t HistogramBars::IndexOf(double value) const
{
  const double bin =
    std::floor((value - this->statistics->Smallest()) / this->statistics->BinSpacing() + 0.5);
  return std::int64_t(std::floor(bin / double(this->binsPerBar)));
}

}
