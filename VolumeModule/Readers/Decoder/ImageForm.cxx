#include "Readers/Decoder/ImageForm.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkPointData.h>

#include <algorithm>

namespace varimarch
{

void ImageForm::Place(vtkImageData* image) const
{
  image->SetOrigin(this->origin.data());
  image->SetSpacing(this->spacing.data());
  image->SetDirectionMatrix(this->direction.data());
  image->GetPointData()->GetScalars()->SetName(this->name.empty() ? nullptr : this->name.c_str());
}

ImageForm FormOf(vtkImageData* image)
{
  ImageForm form;
  const int* const dimensions = image->GetDimensions();
  form.layout = { { dimensions[0], dimensions[1], dimensions[2] }, image->GetScalarType(),
    image->GetNumberOfScalarComponents() };
  const char* const name = image->GetPointData()->GetScalars()->GetName();
  form.name = name ? name : "";
  std::copy_n(image->GetOrigin(), 3, form.origin.begin());
  std::copy_n(image->GetSpacing(), 3, form.spacing.begin());
  std::copy_n(image->GetDirectionMatrix()->GetData(), 9, form.direction.begin());
  return form;
}

}
