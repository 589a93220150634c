#include "Scene/ValueGradientHistogram.h"

#include "Scene/GradientMagnitudes.h"
#include "Scene/LookRegions.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

/// The bin of a number in a range; the range's last number belongs to the last bin.
int BinOf(double number, double first, double last, int bins)
{
  const double width = last > first ? last - first : 1.0;
  return std::clamp(int((number - first) / width * bins), 0, bins - 1);
}

}

std::int64_t ValueGradientHistogram::CountAt(double value, double gradient) const
{
  const bool isInside = value >= this->values[0] && value <= this->values[1] && gradient >= 0.0 &&
    gradient <= this->largestGradient;
  if (this->counts.empty() || !isInside)
  {
    return 0;
  }
  const int column = BinOf(value, this->values[0], this->values[1], Columns);
  const int row = BinOf(gradient, 0.0, this->largestGradient, Rows);
  return this->counts[std::size_t(row) * Columns + std::size_t(column)];
}

ValueGradientHistogram HistogramOf(vtkImageData* volume, vtkImageData* magnitudes)
{
  ValueGradientHistogram histogram;
  vtkDataArray* const scalars = volume->GetPointData()->GetScalars();
  scalars->GetFiniteRange(histogram.values.data(), 0);
  const double steepest = magnitudes->GetScalarRange()[1];
  const double largest = std::min(steepest, LargestRegionGradient(volume));
  histogram.largestGradient = largest > 0.0 ? largest : histogram.largestGradient;
  histogram.counts.assign(std::size_t(histogram.Columns) * histogram.Rows, 0);
  const vtkIdType stride = StrideOfMagnitudes(volume);
  const int* const dimensions = volume->GetDimensions();
  const int* const sampled = magnitudes->GetDimensions();
  const auto* magnitude = static_cast<const float*>(magnitudes->GetScalarPointer());
  for (vtkIdType z = 0; z < sampled[2]; ++z)
  {
    for (vtkIdType y = 0; y < sampled[1]; ++y)
    {
      const vtkIdType line = stride * (z * dimensions[1] + y) * dimensions[0];
      for (vtkIdType x = 0; x < sampled[0]; ++x, ++magnitude)
      {
        const double value = scalars->GetComponent(line + stride * x, 0);
        if (std::isfinite(value))
        {
          const int column =
            BinOf(value, histogram.values[0], histogram.values[1], histogram.Columns);
          const int row = BinOf(*magnitude, 0.0, histogram.largestGradient, histogram.Rows);
          ++histogram.counts[std::size_t(row) * histogram.Columns + std::size_t(column)];
        }
      }
    }
  }
  return histogram;
}

}
