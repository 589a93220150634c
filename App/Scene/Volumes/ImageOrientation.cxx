#include "Scene/Volumes/ImageOrientation.h"

#include <vtkImageFlip.h>
#include <vtkMatrix3x3.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkTransform.h>

namespace varimarch
{

namespace
{

vtkSmartPointer<vtkImageData> Upright(vtkImageData* image)
{
  auto upright = vtkSmartPointer<vtkImageData>::New();
  upright->ShallowCopy(image);
  upright->SetDirectionMatrix(1, 0, 0, 0, 1, 0, 0, 0, 1);
  return upright;
}

}

vtkSmartPointer<vtkImageData> RightHanded(vtkImageData* image)
{
  if (image->GetDirectionMatrix()->Determinant() > 0.0)
  {
    return image;
  }
  vtkNew<vtkImageFlip> flip;
  flip->SetInputData(Upright(image));
  flip->SetFilteredAxis(2);
  flip->Update();
  vtkSmartPointer<vtkImageData> flipped = flip->GetOutput();

  // The first slice is now where the last one was, and the third axis points the other way.
  const int* extent = image->GetExtent();
  double origin[3];
  image->TransformIndexToPhysicalPoint(0, 0, extent[4] + extent[5], origin);
  vtkNew<vtkMatrix3x3> direction;
  direction->DeepCopy(image->GetDirectionMatrix());
  for (int row = 0; row < 3; ++row)
  {
    direction->SetElement(row, 2, -direction->GetElement(row, 2));
  }
  flipped->SetOrigin(origin);
  flipped->SetDirectionMatrix(direction);
  return flipped;
}

vtkSmartPointer<vtkImageData> WithoutDirection(vtkImageData* image, vtkTransform* worldFromImage)
{
  vtkNew<vtkMatrix4x4> turn;
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      turn->SetElement(row, column, image->GetDirectionMatrix()->GetElement(row, column));
    }
  }
  const double* origin = image->GetOrigin();
  worldFromImage->Translate(origin);
  worldFromImage->Concatenate(turn);
  worldFromImage->Translate(-origin[0], -origin[1], -origin[2]);
  return Upright(image);
}

}
