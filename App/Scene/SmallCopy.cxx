#include "Scene/SmallCopy.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkImageShrink3D.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <array>

namespace varimarch
{

vtkSmartPointer<vtkImageData> SmallCopy(vtkImageData* image, int largestSide)
{
  std::array<int, 3> factors;
  std::array<double, 3> firstIndex;
  std::array<double, 3> spacing;
  const int* const extent = image->GetExtent();
  for (int axis = 0; axis < 3; ++axis)
  {
    const int count = extent[2 * axis + 1] - extent[2 * axis] + 1;
    factors[axis] = (count + largestSide - 1) / largestSide;
    // The first mean lies in the middle of the voxels that it replaces.
    firstIndex[axis] = extent[2 * axis] + 0.5 * (factors[axis] - 1);
    spacing[axis] = factors[axis] * image->GetSpacing()[axis];
  }
  std::array<double, 3> origin;
  image->TransformContinuousIndexToPhysicalPoint(firstIndex.data(), origin.data());

  vtkNew<vtkImageShrink3D> shrink;
  shrink->SetInputData(image);
  shrink->SetShrinkFactors(factors.data());
  shrink->Update();
  vtkImageData* const small = shrink->GetOutput();
  small->SetExtent(0, small->GetDimensions()[0] - 1, 0, small->GetDimensions()[1] - 1, 0,
    small->GetDimensions()[2] - 1);
  small->SetOrigin(origin.data());
  small->SetSpacing(spacing.data());
  small->SetDirectionMatrix(image->GetDirectionMatrix());
  // They say whether the components are colours.
  small->GetPointData()->GetScalars()->CopyComponentNames(image->GetPointData()->GetScalars());
  return small;
}

}
