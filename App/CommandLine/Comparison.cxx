#include "Comparison.h"

#include "Scene/OffscreenView.h"
#include "Scene/SceneNames.h"
#include "VtkMessages.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <memory>

namespace varimarch
{

namespace
{

using OnStep = std::function<void(const std::string&)>;

double Median(std::vector<double> numbers)
{
  std::sort(numbers.begin(), numbers.end());
  const std::size_t middle = numbers.size() / 2;
  return numbers.size() % 2 ? numbers[middle] : 0.5 * (numbers[middle - 1] + numbers[middle]);
}

void MarchTruth(
  const Scene& scene, vtkImageData* image, const OnStep& onStep, Comparison& comparison)
{
  constexpr double SamplesPerVoxel = 16.0;
  const double* spacing = image->GetSpacing();
  Scene fine = scene;
  fine.render.acceleration = Acceleration::Off;
  fine.render.earlyTerminationTransmittance = 0.0;
  fine.render.sampleDistanceMm = std::min({ spacing[0], spacing[1], spacing[2] }) / SamplesPerVoxel;

  const auto start = std::chrono::steady_clock::now();
  OffscreenView view(fine, image, MapperKind::Varimarch);
  comparison.truth = view.FloatImage([&](double done)
    { onStep("Marching the reference, " + std::to_string(std::lround(100.0 * done)) + " %"); });
  ThrowIfVtkReportedError();
  comparison.truthSampleDistanceMm = *fine.render.sampleDistanceMm;
  comparison.truthSeconds =
    std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  comparison.openglRenderer = view.DeviceName();
}

// A view of each kind, warmed up, with all of its measurement but the times.
std::vector<std::unique_ptr<OffscreenView>> WarmedUpViews(
  const Scene& scene, vtkImageData* image, const OnStep& onStep, Comparison& comparison)
{
  std::vector<std::unique_ptr<OffscreenView>> views;
  for (const auto& [name, kind] : MapperKindNames())
  {
    onStep("Warming up " + name);
    views.push_back(std::make_unique<OffscreenView>(scene, image, kind));
    OffscreenView& view = *views.back();
    Measurement measurement = {};
    measurement.kind = kind;
    measurement.firstMs = 1000.0 * view.Render();
    measurement.picture = view.FloatImage();
    measurement.sampleDistanceMm = view.Pipeline().UsedSampleDistanceMm();
    measurement.error = ErrorOf(measurement.picture, comparison.truth, scene.background);
    comparison.measurements.push_back(measurement);
    // The first picture into the window's own framebuffer again pays for the change of target.
    view.Render();
    ThrowIfVtkReportedError();
  }
  return views;
}

}

Comparison Compare(const Scene& scene, vtkImageData* image, int rounds,
  const std::function<void(const std::string&)>& onStep)
{
  Comparison comparison = {};
  MarchTruth(scene, image, onStep, comparison);
  const auto views = WarmedUpViews(scene, image, onStep, comparison);
  for (int round = 1; round <= rounds; ++round)
  {
    onStep("Measuring, round " + std::to_string(round) + " of " + std::to_string(rounds));
    for (std::size_t i = 0; i < views.size(); ++i)
    {
      comparison.measurements[i].roundsMs.push_back(1000.0 * views[i]->Render());
    }
  }
  ThrowIfVtkReportedError();
  for (Measurement& measurement : comparison.measurements)
  {
    measurement.medianMs = Median(measurement.roundsMs);
  }
  return comparison;
}

}
