#include "Scene/Looks/ValueGradientHistogram.h"

#include "Scene/Looks/LookRegions.h"

#include <vtkArrayDispatch.h>
#include <vtkDataArray.h>
#include <vtkDataArrayRange.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
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

namespace
{

constexpr double MostMagnitudes = 4e6;

// Visits every `stride`-th voxel along each axis.
struct Sampling
{
  std::array<vtkIdType, 3> dimensions;
  std::array<double, 3> spacingMm;
  vtkIdType stride;

  vtkIdType Count(int axis) const
  {
    return (this->dimensions[axis] + this->stride - 1) / this->stride;
  }
};

Sampling SamplingOf(vtkImageData* image)
{
  const int* const dimensions = image->GetDimensions();
  const double* const spacing = image->GetSpacing();
  const double voxels = double(image->GetNumberOfPoints());
  return { { dimensions[0], dimensions[1], dimensions[2] },
    { std::abs(spacing[0]), std::abs(spacing[1]), std::abs(spacing[2]) },
    vtkIdType(std::ceil(std::cbrt(std::max(1.0, voxels / MostMagnitudes)))) };
}

// Voxels outside the volume repeat the outermost ones.
template <class Tuples>
double MagnitudeAt(
  const Tuples& tuples, const Sampling& sampling, const std::array<vtkIdType, 3>& voxel)
{
  const std::array<vtkIdType, 3> steps = { 1, sampling.dimensions[0],
    sampling.dimensions[0] * sampling.dimensions[1] };
  const vtkIdType middle = voxel[0] + voxel[1] * steps[1] + voxel[2] * steps[2];
  double sum = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const vtkIdType before = voxel[axis] > 0 ? steps[axis] : 0;
    const vtkIdType after = voxel[axis] + 1 < sampling.dimensions[axis] ? steps[axis] : 0;
    const double difference =
      double(tuples[middle + after][0]) - double(tuples[middle - before][0]);
    const double slope = difference / (2.0 * sampling.spacingMm[axis]);
    sum += slope * slope;
  }
  return std::isfinite(sum) ? std::sqrt(sum) : 0.0;
}

}

vtkIdType StrideOfMagnitudes(vtkImageData* image)
{
  return SamplingOf(image).stride;
}

vtkSmartPointer<vtkImageData> GradientMagnitudes(vtkImageData* image)
{
  const Sampling sampling = SamplingOf(image);
  auto magnitudes = vtkSmartPointer<vtkImageData>::New();
  magnitudes->SetDimensions(int(sampling.Count(0)), int(sampling.Count(1)), int(sampling.Count(2)));
  magnitudes->AllocateScalars(VTK_FLOAT, 1);
  auto* const results = static_cast<float*>(magnitudes->GetScalarPointer());
  const auto measure = [&](auto* array)
  {
    const auto tuples = vtk::DataArrayTupleRange(array);
    tbb::parallel_for(vtkIdType(0), sampling.Count(2),
      [&](vtkIdType z)
      {
        float* result = results + z * sampling.Count(0) * sampling.Count(1);
        for (vtkIdType y = 0; y < sampling.Count(1); ++y)
        {
          for (vtkIdType x = 0; x < sampling.Count(0); ++x)
          {
            *result++ = float(MagnitudeAt(
              tuples, sampling, { x * sampling.stride, y * sampling.stride, z * sampling.stride }));
          }
        }
      });
  };
  vtkDataArray* const scalars = image->GetPointData()->GetScalars();
  if (!vtkArrayDispatch::Dispatch::Execute(scalars, measure))
  {
    measure(scalars);
  }
  return magnitudes;
}

}
