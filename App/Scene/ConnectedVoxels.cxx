#include "Scene/ConnectedVoxels.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>

namespace varimarch
{

vtkSmartPointer<vtkImageConnectivityFilter> NewConnectivity(
  vtkImageData* image, double smallest, double largest)
{
  vtkNew<vtkImageData> plain;
  plain->SetDimensions(image->GetDimensions());
  plain->GetPointData()->SetScalars(image->GetPointData()->GetScalars());
  auto filter = vtkSmartPointer<vtkImageConnectivityFilter>::New();
  filter->SetInputData(plain);
  filter->SetScalarRange(smallest, largest);
  filter->SetLabelModeToConstantValue();
  filter->SetLabelConstantValue(1);
  filter->SetLabelScalarTypeToUnsignedChar();
  return filter;
}

}
