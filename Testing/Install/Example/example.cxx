// A program outside the tree that uses the installed module; README shows its CMakeLists.txt.

#include <vtkColorTransferFunction.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkRTAnalyticSource.h>
#include <vtkVariationFieldVolumeMapper.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <cstdlib>
#include <iostream>

int main()
{
  vtkNew<vtkRTAnalyticSource> wavelet;
  vtkNew<vtkVariationFieldVolumeMapper> mapper;
  mapper->SetInputConnection(wavelet->GetOutputPort());
  mapper->SetAccelerationModeToScalarField();

  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  const double* bounds = volume->GetBounds();
  std::cout << mapper->GetClassName() << ": x from " << bounds[0] << " to " << bounds[1] << '\n';
  return bounds[0] == -10.0 && bounds[1] == 10.0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
