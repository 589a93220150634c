#include "Scene/ImageStatistics.h"

#include <vtkDataArray.h>
#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkImageHistogram.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <algorithm>

namespace varimarch
{

ImageStatistics::ImageStatistics(vtkImageData* image)
{
  constexpr double MostBins = 65536.0;
  double range[2];
  image->GetPointData()->GetScalars()->GetFiniteRange(range, 0);
  this->smallest = range[0];
  this->largest = range[1];

  // Whole numbers get a bin each where they are few enough; a bin is centred on its value.
  const double width = this->largest - this->smallest;
  const int type = image->GetScalarType();
  const bool oneByOne = type != VTK_FLOAT && type != VTK_DOUBLE && width < MostBins;
  const double bins = oneByOne ? width + 1.0 : width > 0.0 ? MostBins : 1.0;
  this->binSpacing = bins > 1.0 ? width / (bins - 1.0) : 1.0;

  vtkNew<vtkImageHistogram> histogram;
  histogram->SetInputData(image);
  histogram->SetActiveComponent(0);
  histogram->AutomaticBinningOff();
  histogram->SetNumberOfBins(int(bins));
  histogram->SetBinOrigin(this->smallest);
  histogram->SetBinSpacing(this->binSpacing);
  histogram->GenerateHistogramImageOff();
  histogram->Update();
  vtkIdTypeArray* counted = histogram->GetHistogram();
  this->counts.assign(
    counted->GetPointer(0), counted->GetPointer(0) + counted->GetNumberOfTuples());
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
