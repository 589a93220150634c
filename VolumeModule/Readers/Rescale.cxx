#include "Readers/Rescale.h"

#include "Readers/VoxelLayout.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace varimarch
{
namespace
{

template <class Type>
bool Holds(double smallest, double largest)
{
  return smallest >= double(std::numeric_limits<Type>::lowest()) &&
    largest <= double(std::numeric_limits<Type>::max());
}

bool IsIntegral(double number)
{
  return number == std::floor(number);
}

bool IsIdentity(const Rescale& rescale)
{
  return rescale.slope == 1.0 && rescale.intercept == 0.0;
}

/// Smallest and largest possible result, given the stored values.
std::array<double, 2> ResultRange(vtkImageData* image, const std::vector<Rescale>& slices)
{
  std::array<double, 2> stored = { VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX };
  for (int component = 0; component < image->GetNumberOfScalarComponents(); ++component)
  {
    const double* const range = image->GetPointData()->GetScalars()->GetRange(component);
    stored = { std::min(stored[0], range[0]), std::max(stored[1], range[1]) };
  }
  std::array<double, 2> range = { VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX };
  for (const Rescale& slice : slices)
  {
    for (const double value : stored)
    {
      range[0] = std::min(range[0], slice.slope * value + slice.intercept);
      range[1] = std::max(range[1], slice.slope * value + slice.intercept);
    }
  }
  return range;
}

int ResultType(vtkImageData* image, const std::vector<Rescale>& slices)
{
  const int storedType = image->GetScalarType();
  const bool isFloat = storedType == VTK_FLOAT;
  const bool isInteger = !isFloat && storedType != VTK_DOUBLE;
  const bool isExact = std::all_of(slices.begin(), slices.end(),
    [](const Rescale& slice) { return IsIntegral(slice.slope) && IsIntegral(slice.intercept); });
  if (isInteger && isExact)
  {
    const std::array<double, 2> range = ResultRange(image, slices);
    if (Holds<short>(range[0], range[1]))
    {
      return VTK_SHORT;
    }
    if (Holds<int>(range[0], range[1]))
    {
      return VTK_INT;
    }
  }
  // A float has a precision of 24 bits.
  return isFloat || image->GetScalarSize() <= 2 ? VTK_FLOAT : VTK_DOUBLE;
}

/// Converts slice by slice; stored values and results of the same type may share their memory.
template <class Stored, class Result>
void Convert(const Stored* stored, std::size_t sliceValues, const std::vector<Rescale>& slices,
  Result* results)
{
  for (const Rescale& slice : slices)
  {
    results = std::transform(stored, stored + sliceValues, results,
      [&](Stored value) { return Result(slice.slope * double(value) + slice.intercept); });
    stored += sliceValues;
  }
}

template <class Stored>
void ConvertTo(vtkImageData* result, const Stored* stored, std::size_t sliceValues,
  const std::vector<Rescale>& slices)
{
  void* const results = result->GetScalarPointer();
  switch (result->GetScalarType())
  {
    case VTK_SHORT:
      return Convert(stored, sliceValues, slices, static_cast<short*>(results));
    case VTK_INT:
      return Convert(stored, sliceValues, slices, static_cast<int*>(results));
    case VTK_FLOAT:
      return Convert(stored, sliceValues, slices, static_cast<float*>(results));
    default:
      return Convert(stored, sliceValues, slices, static_cast<double*>(results));
  }
}

}

vtkSmartPointer<vtkImageData> Rescaled(
  const std::string& path, vtkSmartPointer<vtkImageData> image, const std::vector<Rescale>& slices)
{
  if (std::all_of(slices.begin(), slices.end(), IsIdentity))
  {
    return image;
  }
  const int* dimensions = image->GetDimensions();
  const VoxelLayout layout = { { dimensions[0], dimensions[1], dimensions[2] },
    ResultType(image, slices), image->GetNumberOfScalarComponents() };
  CheckedByteCount(path, layout);
  const bool isSameType = layout.scalarType == image->GetScalarType();
  auto result = isSameType ? image : AllocatedImage(layout);
  const auto sliceValues =
    std::size_t(image->GetNumberOfPoints()) * std::size_t(layout.componentCount) / slices.size();
  const void* stored = image->GetScalarPointer();
  switch (image->GetScalarType())
  {
    vtkTemplateMacro(
      ConvertTo(result.Get(), static_cast<const VTK_TT*>(stored), sliceValues, slices));
  }
  result->GetPointData()->GetScalars()->Modified(); // discards the cached range
  return result;
}

namespace
{

template <class Component, class Result>
void Convert(const Component* components, int count, std::size_t voxelCount, Result* results)
{
  for (std::size_t voxel = 0; voxel < voxelCount; ++voxel)
  {
    double sum = 0.0;
    for (int i = 0; i < count; ++i, ++components)
    {
      sum += double(*components) * double(*components);
    }
    results[voxel] = Result(std::sqrt(sum));
  }
}

}

void TakeMagnitude(const std::string& reason, Volume& volume)
{
  vtkImageData* image = volume.image;
  const bool isShort = image->GetScalarSize() <= 2 || image->GetScalarType() == VTK_FLOAT;
  const int* dimensions = image->GetDimensions();
  auto result = AllocatedImage(
    { { dimensions[0], dimensions[1], dimensions[2] }, isShort ? VTK_FLOAT : VTK_DOUBLE });
  const int count = image->GetNumberOfScalarComponents();
  const auto voxelCount = std::size_t(image->GetNumberOfPoints());
  switch (image->GetScalarType())
  {
    vtkTemplateMacro(
      const auto* components = static_cast<VTK_TT*>(image->GetScalarPointer()); isShort
        ? Convert(components, count, voxelCount, static_cast<float*>(result->GetScalarPointer()))
        : Convert(components, count, voxelCount, static_cast<double*>(result->GetScalarPointer())));
  }
  result->SetOrigin(image->GetOrigin());
  result->SetSpacing(image->GetSpacing());
  result->SetDirectionMatrix(image->GetDirectionMatrix());
  volume.image = result;
  volume.warnings.push_back(reason + ", of which the magnitude was read.");
}

}
