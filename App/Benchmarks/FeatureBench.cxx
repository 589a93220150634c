#include "FeatureBench.h"

#include "CommandLine/Results.h"
#include "CommandLine/VtkMessages.h"
#include "Scene/ImageOrientation.h"
#include "Scene/Median.h"
#include "Scene/SceneCamera.h"
#include "Scene/VolumeProperty.h"

#include <vtkCamera.h>
#include <vtkDataArray.h>
#include <vtkHeadlessRenderWindow.h>
#include <vtkNew.h>
#include <vtkOpenGLGPUVolumeRayCastMapper.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkTransform.h>
#include <vtkVariationFieldGPUVolumeRayCastMapper.h>
#include <vtkVolumeProperty.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <chrono>
#include <numeric>
#include <stdexcept>

namespace varimarch
{

namespace
{

constexpr int PicturesPerSweep = 3;
constexpr double DegreesPerPicture = 2.0;

// Short times are repeated often, because other processes disturb them most.
constexpr double ShortestTimeMs = 250.0;

// A window that shows a scene through the interface that all of VTK's GPU mappers share.
class FeatureView
{
public:
  FeatureView(
    const Scene& scene, vtkImageData* image, vtkSmartPointer<vtkGPUVolumeRayCastMapper> mapper)
    : mapper(std::move(mapper))
  {
    vtkNew<vtkTransform> worldFromImage;
    this->image = WithoutDirection(RightHanded(image), worldFromImage);
    this->mapper->SetInputDataObject(this->image);
    this->volume->SetUserTransform(worldFromImage);
    this->volume->SetMapper(this->mapper);
    ApplyLook(InUnitsOfData(scene.look, image), MeanSpacingMm(image), this->volume->GetProperty());
    this->renderer->AddVolume(this->volume);
    PlaceCamera(scene.camera, image->GetBounds(), double(scene.size[0]) / scene.size[1],
      this->renderer->GetActiveCamera());
    this->window->SetSize(scene.size[0], scene.size[1]);
    this->window->AddRenderer(this->renderer);
  }

  FeatureStage Stage() { return { this->mapper, this->volume, this->renderer, this->image }; }

  // The time of a frame after the switched feature has been built.
  double MedianMs()
  {
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
  void Sweep(std::vector<double>& timesMs)
  {
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

  // True if the last frame is black everywhere.
  bool ShowsNothing()
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

private:
  vtkSmartPointer<vtkImageData> image;
  vtkSmartPointer<vtkGPUVolumeRayCastMapper> mapper;
  vtkNew<vtkVolume> volume;
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkHeadlessRenderWindow> window;
};

FeatureCost CostOf(const Feature& feature, FeatureView& view)
{
  FeatureCost cost = {};
  feature.prepare(view.Stage());
  cost.beforeMs = view.MedianMs();
  feature.switchOn(view.Stage());
  cost.onMs = view.MedianMs();
  feature.switchOff(view.Stage());
  cost.afterMs = view.MedianMs();
  return cost;
}

FeatureCost MedianOf(const std::vector<FeatureCost>& costs)
{
  FeatureCost median = {};
  for (double FeatureCost::*time :
    { &FeatureCost::beforeMs, &FeatureCost::onMs, &FeatureCost::afterMs })
  {
    std::vector<double> times;
    for (const FeatureCost& cost : costs)
    {
      times.push_back(cost.*time);
    }
    median.*time = Median(times);
  }
  return median;
}

void SwitchOn(const Feature& feature, FeatureView& view)
{
  feature.prepare(view.Stage());
  feature.switchOn(view.Stage());
  view.MedianMs();
}

// Checks how each mapper handles the feature.
void FindWhoDraws(const Scene& scene, vtkImageData* image, FeatureMeasurement& measurement)
{
  const auto ours = vtkSmartPointer<vtkVariationFieldGPUVolumeRayCastMapper>::New();
  FeatureView ourView(scene, image, ours);
  SwitchOn(*measurement.feature, ourView);
  measurement.drawnByVtk = ours->GetReasonForVtkMapper();

  FeatureView vtkView(scene, image, vtkSmartPointer<vtkOpenGLGPUVolumeRayCastMapper>::New());
  SwitchOn(*measurement.feature, vtkView);
  measurement.vtkShowsNothing = vtkView.ShowsNothing() && !ourView.ShowsNothing();
}

}

FeatureMeasurement MeasureFeature(
  const Feature& feature, const Scene& scene, vtkImageData* image, int rounds, const OnStep& onStep)
{
  FeatureMeasurement measurement = { &feature, {}, {}, "", false, "" };
  try
  {
    FindWhoDraws(scene, image, measurement);
    std::vector<FeatureCost> ours;
    std::vector<FeatureCost> vtk;
    for (int round = 1; round <= rounds; ++round)
    {
      onStep(feature.name + ", round " + std::to_string(round) + " of " + std::to_string(rounds));
      FeatureView ourView(
        scene, image, vtkSmartPointer<vtkVariationFieldGPUVolumeRayCastMapper>::New());
      ours.push_back(CostOf(feature, ourView));
      FeatureView vtkView(scene, image, vtkSmartPointer<vtkOpenGLGPUVolumeRayCastMapper>::New());
      vtk.push_back(CostOf(feature, vtkView));
    }
    measurement.ours = MedianOf(ours);
    measurement.vtk = MedianOf(vtk);
  }
  catch (const std::runtime_error& problem)
  {
    measurement.failure = problem.what();
  }
  return measurement;
}

}
