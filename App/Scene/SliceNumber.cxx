#include "Scene/SliceNumber.h"

#include "Scene/WorldVector.h"

#include <vtkImageData.h>
#include <vtkMatrix3x3.h>

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

// The cosine between an axis of the image and the normal of a plane.
double CosineOf(vtkImageData* image, SlicePlane plane, int axis)
{
  const std::array<double, 3> through = AxesOf(plane).through;
  double cosine = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    cosine += image->GetDirectionMatrix()->GetElement(i, axis) * through[i];
  }
  return std::abs(cosine);
}

int NearestAxis(vtkImageData* image, SlicePlane plane)
{
  int nearest = 0;
  for (const int axis : { 1, 2 })
  {
    nearest = CosineOf(image, plane, axis) > CosineOf(image, plane, nearest) ? axis : nearest;
  }
  return nearest;
}

}

std::optional<SliceNumber> SliceNumberAt(
  vtkImageData* image, SlicePlane plane, const std::array<double, 3>& pointMm)
{
  constexpr double SmallestCosine = 0.9999; // 0.8 degrees
  const int axis = NearestAxis(image, plane);
  if (CosineOf(image, plane, axis) < SmallestCosine)
  {
    return std::nullopt;
  }
  double index[3];
  image->TransformPhysicalPointToContinuousIndex(pointMm.data(), index);
  const int first = image->GetExtent()[2 * axis];
  const int count = image->GetDimensions()[axis];
  return SliceNumber{ 1 + int(std::lround(std::clamp(index[axis] - first, 0.0, count - 1.0))),
    count };
}

double SliceStepMm(vtkImageData* image, SlicePlane plane)
{
  return image->GetSpacing()[NearestAxis(image, plane)];
}

}
