#include "Scene/ConnectedVoxels.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <cmath>

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
  // VTK's filter rounds the range of whole values towards 0.
  const int type = image->GetScalarType();
  const bool areWhole = type != VTK_FLOAT && type != VTK_DOUBLE;
  filter->SetScalarRange(
    areWhole ? std::ceil(smallest) : smallest, areWhole ? std::floor(largest) : largest);
  filter->SetLabelModeToConstantValue();
  filter->SetLabelConstantValue(1);
  filter->SetLabelScalarTypeToUnsignedShort();
  return filter;
}

}
