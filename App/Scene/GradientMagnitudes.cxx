#include "Scene/GradientMagnitudes.h"

#include <vtkArrayDispatch.h>
#include <vtkDataArray.h>
#include <vtkDataArrayRange.h>
#include <vtkPointData.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace varimarch
{

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
