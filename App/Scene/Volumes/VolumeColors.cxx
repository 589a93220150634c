#include "Scene/Volumes/VolumeColors.h"

#include "Readers/ImageFacts.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace varimarch
{

namespace
{

// Largest value of a component of a byte.
constexpr double White = 255.0;

// Factor from the numbers of the image to those of bytes.
double FactorToBytes(vtkDataArray* scalars)
{
  if (scalars->GetDataType() == VTK_UNSIGNED_CHAR)
  {
    return 1.0;
  }
  double largest = 0.0;
  for (int component = 0; component < scalars->GetNumberOfComponents(); ++component)
  {
    double range[2];
    scalars->GetFiniteRange(range, component);
    largest = std::max(largest, range[1]);
  }
  return largest > 0.0 ? White / largest : 1.0;
}

unsigned char ByteOf(double number)
{
  // The comparison is false for NaN.
  return number > 0.0 ? static_cast<unsigned char>(std::lround(std::min(number, White))) : 0;
}

// Luminance of a colour by ITU-R BT.709, of its numbers as they are.
double Luminance(const std::array<double, 3>& rgb)
{
  return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
}

bool HasAlpha(vtkDataArray* scalars)
{
  const int last = scalars->GetNumberOfComponents() - 1;
  double range[2];
  scalars->GetFiniteRange(range, last);
  return last % 2 == 1 && range[0] < range[1];
}

}

vtkSmartPointer<vtkImageData> ColoredVoxels(vtkImageData* image)
{
  if (!HoldsColors(image))
  {
    return image;
  }
  vtkDataArray* const scalars = image->GetPointData()->GetScalars();
  const int last = scalars->GetNumberOfComponents() - 1;
  const bool isGray = last == 1;
  const bool hasAlpha = HasAlpha(scalars);
  const double factor = FactorToBytes(scalars);
  auto colored = vtkSmartPointer<vtkImageData>::New();
  colored->CopyStructure(image);
  colored->AllocateScalars(VTK_UNSIGNED_CHAR, AlphaComponent + 1);
  auto* const bytes = static_cast<unsigned char*>(colored->GetScalarPointer());
  tbb::parallel_for(tbb::blocked_range<vtkIdType>(0, scalars->GetNumberOfTuples(), 65536),
    [&](const tbb::blocked_range<vtkIdType>& range)
    {
      for (vtkIdType i = range.begin(); i != range.end(); ++i)
      {
        std::array<double, 3> rgb;
        for (int c = 0; c < 3; ++c)
        {
          rgb[c] = factor * scalars->GetComponent(i, isGray ? 0 : c);
          bytes[4 * i + c] = ByteOf(rgb[c]);
        }
        bytes[4 * i + AlphaComponent] =
          ByteOf(hasAlpha ? factor * scalars->GetComponent(i, last) : Luminance(rgb));
      }
    });
  return colored;
}

}
