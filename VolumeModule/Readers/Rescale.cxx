#include "Readers/Rescale.h"

#include "Readers/VoxelLayout.h"

#include <vtkImageData.h>

#include <algorithm>
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

int ResultType(vtkImageData* image, const Rescale& rescale)
{
  const int storedType = image->GetScalarType();
  const bool isFloat = storedType == VTK_FLOAT;
  const bool isInteger = !isFloat && storedType != VTK_DOUBLE;
  if (isInteger && IsIntegral(rescale.slope) && IsIntegral(rescale.intercept))
  {
    double range[2];
    image->GetScalarRange(range);
    const double a = rescale.slope * range[0] + rescale.intercept;
    const double b = rescale.slope * range[1] + rescale.intercept;
    if (Holds<short>(std::min(a, b), std::max(a, b)))
    {
      return VTK_SHORT;
    }
    if (Holds<int>(std::min(a, b), std::max(a, b)))
    {
      return VTK_INT;
    }
  }
  // A float holds 24 bits.
  return isFloat || image->GetScalarSize() <= 2 ? VTK_FLOAT : VTK_DOUBLE;
}

template <class Stored, class Result>
void Convert(const Stored* stored, std::size_t count, const Rescale& rescale, Result* results)
{
  std::transform(stored, stored + count, results,
    [&](Stored value) { return Result(rescale.slope * double(value) + rescale.intercept); });
}

template <class Stored>
void Convert(const Stored* stored, std::size_t count, const Rescale& rescale, vtkImageData* result)
{
  void* const results = result->GetScalarPointer();
  switch (result->GetScalarType())
  {
    case VTK_SHORT:
      return Convert(stored, count, rescale, static_cast<short*>(results));
    case VTK_INT:
      return Convert(stored, count, rescale, static_cast<int*>(results));
    case VTK_FLOAT:
      return Convert(stored, count, rescale, static_cast<float*>(results));
    default:
      return Convert(stored, count, rescale, static_cast<double*>(results));
  }
}

}

vtkSmartPointer<vtkImageData> Rescaled(
  const std::string& path, vtkSmartPointer<vtkImageData> image, const Rescale& rescale)
{
  if (rescale.slope == 1.0 && rescale.intercept == 0.0)
  {
    return image;
  }
  const int* dimensions = image->GetDimensions();
  const VoxelLayout layout = { { dimensions[0], dimensions[1], dimensions[2] },
    ResultType(image, rescale), image->GetNumberOfScalarComponents() };
  CheckedByteCount(path, layout);
  auto result = AllocatedImage(layout);
  const auto count = std::size_t(image->GetNumberOfPoints()) * std::size_t(layout.componentCount);
  const void* stored = image->GetScalarPointer();
  switch (image->GetScalarType())
  {
    vtkTemplateMacro(Convert(static_cast<const VTK_TT*>(stored), count, rescale, result.Get()));
  }
  return result;
}

}
