#include "FeatureView.h"

#include "CommandLine/ReportedErrors.h"
#include "Scene/Looks/VolumeProperty.h"
#include "Scene/Median.h"
#include "Scene/Model/SceneCamera.h"
#include "Scene/Volumes/ImageOrientation.h"

#include <vtkCamera.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkTransform.h>
#include <vtkVolumeProperty.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <chrono>
#include <numeric>

namespace varimarch
{

FeatureView::FeatureView(
  const Scene& scene, vtkImageData* image, vtkSmartPointer<vtkGPUVolumeRayCastMapper> mapper)
  : mapper(std::move(mapper))
{
  vtkNew<vtkTransform> worldFromImage;
  this->image = WithoutDirection(RightHanded(image), worldFromImage);
  this->mapper->SetInputDataObject(this->image);
  this->volume->SetUserTransform(worldFromImage);
  this->volume->SetMapper(this->mapper);
  ApplyLook(InUnitsOfData(scene.look, image), image, this->volume->GetProperty());
  this->volume->GetProperty()->SetInterpolationTypeToLinear(); // the nearest voxel is VTK's default
  this->renderer->AddVolume(this->volume);
  PlaceCamera(scene.camera, image->GetBounds(), double(scene.size[0]) / scene.size[1],
    this->renderer->GetActiveCamera());
  this->window->SetSize(scene.size[0], scene.size[1]);
  this->window->AddRenderer(this->renderer);
}

// Short times are repeated often, because other processes disturb them most.
double FeatureView::MedianMs()
{
  constexpr double ShortestTimeMs = 250.0;
  this->window->Render();
  ThrowIfVtkReportedError();
  std::vector<double> times;
  do
  {
    this->Sweep(times);
  } while (std::accumulate(times.begin(), times.end(), 0.0) < ShortestTimeMs);
  return Median(times);
}

// Draws frames of a moving camera, which ends where it began.
void FeatureView::Sweep(std::vector<double>& timesMs)
{
  constexpr int PicturesPerSweep = 3;
  constexpr double DegreesPerPicture = 2.0;
  for (int picture = 0; picture < PicturesPerSweep; ++picture)
  {
    this->renderer->GetActiveCamera()->Azimuth(DegreesPerPicture);
    this->renderer->ResetCameraClippingRange();
    const auto start = std::chrono::steady_clock::now();
    this->window->Render();
    this->window->WaitForCompletion();
    const std::chrono::duration<double, std::milli> elapsed =
      std::chrono::steady_clock::now() - start;
    timesMs.push_back(elapsed.count());
  }
  this->renderer->GetActiveCamera()->Azimuth(-PicturesPerSweep * DegreesPerPicture);
  this->renderer->ResetCameraClippingRange();
}

bool FeatureView::ShowsNothing()
{
  vtkNew<vtkWindowToImageFilter> pixels;
  pixels->SetInput(this->window);
  pixels->ReadFrontBufferOff();
  pixels->ShouldRerenderOff();
  pixels->Update();
  vtkDataArray* channels = pixels->GetOutput()->GetPointData()->GetScalars();
  double largest = 0.0;
  for (int channel = 0; channel < channels->GetNumberOfComponents(); ++channel)
  {
    largest = std::max(largest, channels->GetRange(channel)[1]);
  }
  return largest == 0.0;
}

}
