// A program outside the tree that uses the installed module. Documentation/Installing.md shows its
// CMakeLists.txt.
// It draws a wavelet without showing a window, and fails unless it stands in the picture's middle.

#include <vtkColorTransferFunction.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkRTAnalyticSource.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>
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

  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  vtkNew<vtkColorTransferFunction> green;
  green->AddRGBPoint(0.0, 0.0, 1.0, 0.0);
  volume->GetProperty()->SetColor(green);
  // The wavelet's peak of 277 lies in its middle, and its corners at 40 are below the ramp.
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(200.0, 0.0);
  opacity->AddPoint(250.0, 1.0);
  volume->GetProperty()->SetScalarOpacity(opacity);

  vtkNew<vtkRenderer> renderer;
  renderer->AddVolume(volume);
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(true);
  window->SetSize(64, 64);
  window->AddRenderer(renderer);
  window->Render();

  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(0, 0, 63, 63, false, pixels);
  const double* corner = pixels->GetTuple3(0);
  std::cout << "corner " << corner[0] << ' ' << corner[1] << ' ' << corner[2];
  const bool isCornerBlack = corner[0] + corner[1] + corner[2] == 0.0;
  const double* middle = pixels->GetTuple3(32 * 64 + 32);
  std::cout << ", middle " << middle[0] << ' ' << middle[1] << ' ' << middle[2] << '\n';
  const bool isMiddleGreen = middle[0] == 0.0 && middle[1] > 200.0 && middle[2] == 0.0;
  return isCornerBlack && isMiddleGreen ? EXIT_SUCCESS : EXIT_FAILURE;
}
