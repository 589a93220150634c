// A program that uses only VTK. It renders a wavelet with one of the mappers that leave the choice
// of class to VTK's factory, and prints the class that the factory made.
//
// Usage: draw gpu|several|smart|component|magnitude|blocks PICTURE.ppm

#include <vtkColorTransferFunction.h>
#include <vtkExtractVOI.h>
#include <vtkFloatArray.h>
#include <vtkGPUVolumeRayCastMapper.h>
#include <vtkImageData.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkMultiBlockVolumeMapper.h>
#include <vtkMultiVolume.h>
#include <vtkNew.h>
#include <vtkPNMWriter.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPointData.h>
#include <vtkRTAnalyticSource.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkSmartVolumeMapper.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>
#include <vtkWindowToImageFilter.h>

#include <iostream>
#include <string>

namespace
{

vtkSmartPointer<vtkVolumeMapper> GpuMapper(vtkRTAnalyticSource* wavelet)
{
  vtkNew<vtkGPUVolumeRayCastMapper> mapper;
  mapper->SetInputConnection(wavelet->GetOutputPort());
  mapper->AutoAdjustSampleDistancesOff();
  mapper->SetSampleDistance(0.05F);
  std::cout << mapper->GetClassName() << '\n';
  return mapper;
}

vtkSmartPointer<vtkVolumeMapper> SmartMapper(vtkRTAnalyticSource* wavelet)
{
  vtkNew<vtkSmartVolumeMapper> mapper;
  mapper->SetInputConnection(wavelet->GetOutputPort());
  return mapper;
}

// Vectors whose second component, or whose magnitude, is the wavelet.
vtkSmartPointer<vtkImageData> Vectors(vtkImageData* wavelet, bool magnitude)
{
  vtkNew<vtkFloatArray> vectors;
  vectors->SetName("vectors");
  vectors->SetNumberOfComponents(3);
  vectors->SetNumberOfTuples(wavelet->GetNumberOfPoints());
  for (vtkIdType point = 0; point < wavelet->GetNumberOfPoints(); ++point)
  {
    const double value = wavelet->GetPointData()->GetScalars()->GetComponent(point, 0);
    magnitude ? vectors->SetTuple3(point, 0.6 * value, 0.0, -0.8 * value)
              : vectors->SetTuple3(point, 300.0 - value, value, 200.0);
  }
  vtkNew<vtkImageData> image;
  image->CopyStructure(wavelet);
  image->GetPointData()->SetScalars(vectors);
  return image;
}

vtkSmartPointer<vtkVolumeMapper> VectorMapper(vtkRTAnalyticSource* wavelet, bool magnitude)
{
  wavelet->Update();
  vtkNew<vtkSmartVolumeMapper> mapper;
  mapper->SetInputData(Vectors(wavelet->GetOutput(), magnitude));
  mapper->SetVectorMode(
    magnitude ? vtkSmartVolumeMapper::MAGNITUDE : vtkSmartVolumeMapper::COMPONENT);
  mapper->SetVectorComponent(1);
  return mapper;
}

vtkSmartPointer<vtkVolumeMapper> BlocksMapper(vtkRTAnalyticSource* wavelet)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (int block = 0; block < 2; ++block)
  {
    vtkNew<vtkExtractVOI> half;
    half->SetInputConnection(wavelet->GetOutputPort());
    half->SetVOI(block == 0 ? -16 : 0, block == 0 ? 0 : 16, -16, 16, -16, 16);
    half->Update();
    blocks->SetBlock(block, half->GetOutput());
  }
  vtkNew<vtkMultiBlockVolumeMapper> mapper;
  mapper->SetInputDataObject(blocks);
  return mapper;
}

vtkSmartPointer<vtkVolumeMapper> Mapper(const std::string& kind, vtkRTAnalyticSource* wavelet)
{
  if (kind == "blocks")
  {
    return BlocksMapper(wavelet);
  }
  if (kind == "component" || kind == "magnitude")
  {
    return VectorMapper(wavelet, kind == "magnitude");
  }
  return kind == "smart" ? SmartMapper(wavelet) : GpuMapper(wavelet);
}

void SetLook(vtkVolumeProperty* property)
{
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(30.0, 0.1, 0.2, 0.9);
  color->AddRGBPoint(280.0, 1.0, 0.7, 0.3);
  property->SetColor(color);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(100.0, 0.0);
  opacity->AddPoint(280.0, 0.3);
  property->SetScalarOpacity(opacity);
  property->SetInterpolationTypeToLinear();
}

// Two overlapping volumes, each with its own wavelet.
vtkSmartPointer<vtkVolume> Several(vtkVolume* volume, vtkRTAnalyticSource* second)
{
  vtkNew<vtkVolume> other;
  SetLook(other->GetProperty());
  other->RotateY(30.0);
  other->SetPosition(8.0, 2.0, -3.0);
  volume->GetMapper()->SetInputConnection(1, second->GetOutputPort());
  auto several = vtkSmartPointer<vtkMultiVolume>::New();
  several->SetMapper(volume->GetMapper());
  several->SetVolume(volume, 0);
  several->SetVolume(other, 1);
  return several;
}

}

int main(int argumentCount, char** arguments)
{
  if (argumentCount != 3)
  {
    return 2;
  }
  vtkNew<vtkRTAnalyticSource> wavelet;
  wavelet->SetWholeExtent(-16, 16, -16, 16, -16, 16);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(Mapper(arguments[1], wavelet));
  SetLook(volume->GetProperty());

  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkRTAnalyticSource> second;
  second->SetWholeExtent(-12, 12, -14, 14, -16, 16);
  const bool overlap = std::string(arguments[1]) == "several";
  const vtkSmartPointer<vtkVolume> drawn =
    overlap ? Several(volume, second) : vtkSmartPointer<vtkVolume>(volume);
  renderer->AddVolume(drawn);
  vtkNew<vtkRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(96, 96);
  window->AddRenderer(renderer);
  window->Render();

  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  grab->ReadFrontBufferOff();
  vtkNew<vtkPNMWriter> writer;
  writer->SetInputConnection(grab->GetOutputPort());
  writer->SetFileName(arguments[2]);
  writer->Write();
  return 0;
}
