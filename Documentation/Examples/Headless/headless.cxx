// Draws a volume file into a picture, on a machine that has no display.
// Usage: headless VOLUME PICTURE.png

#include <vtkColorTransferFunction.h>
#include <vtkHeadlessRenderWindow.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPiecewiseFunction.h>
#include <vtkRenderer.h>
#include <vtkVariationFieldVolumeMapper.h>
#include <vtkVolume.h>
#include <vtkVolumeFileReader.h>
#include <vtkVolumeProperty.h>
#include <vtkWindowToImageFilter.h>

#include <cstdlib>
#include <iostream>

namespace
{

// From nothing to solid, over the whole range of the values.
void ShowRange(const double range[2], vtkVolumeProperty* property)
{
  vtkNew<vtkColorTransferFunction> colors;
  colors->AddRGBPoint(range[0], 0.8, 0.4, 0.3);
  colors->AddRGBPoint(range[1], 1.0, 1.0, 0.9);
  vtkNew<vtkPiecewiseFunction> opacities;
  opacities->AddPoint(range[0] + 0.2 * (range[1] - range[0]), 0.0);
  opacities->AddPoint(range[1], 1.0);
  property->SetColor(colors);
  property->SetScalarOpacity(opacities);
}

void WritePicture(vtkRenderWindow* window, const char* path)
{
  vtkNew<vtkWindowToImageFilter> picture;
  picture->SetInput(window);
  picture->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(path);
  writer->SetInputConnection(picture->GetOutputPort());
  writer->Write();
}

}

int main(int argc, char** argv)
{
  if (argc != 3)
  {
    std::cerr << "Usage: headless VOLUME PICTURE.png\n";
    return EXIT_FAILURE;
  }
  vtkNew<vtkVolumeFileReader> reader;
  reader->SetFileName(argv[1]);
  reader->Update();
  if (reader->GetErrorCode())
  {
    return EXIT_FAILURE; // VTK has printed the reason.
  }

  vtkNew<vtkVariationFieldVolumeMapper> mapper;
  mapper->SetInputConnection(reader->GetOutputPort());
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  ShowRange(reader->GetOutput()->GetScalarRange(), volume->GetProperty());
  vtkNew<vtkRenderer> renderer;
  renderer->AddVolume(volume);

  vtkNew<vtkHeadlessRenderWindow> window;
  if (!window->InitializeContext())
  {
    std::cerr << window->GetFailureReason() << '\n';
    return EXIT_FAILURE;
  }
  window->SetSize(256, 256);
  window->AddRenderer(renderer);
  window->Render();
  WritePicture(window, argv[2]);
  std::cout << "drawn by " << window->GetDeviceName() << '\n';
  return EXIT_SUCCESS;
}
