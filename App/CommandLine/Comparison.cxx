#include "Comparison.h"

#include "ReportedErrors.h"
#include "Results.h"
#include "Scene/Images/OffscreenView.h"
#include "Scene/Json/SceneNames.h"
#include "Scene/Median.h"

#include <memory>

namespace varimarch
{

namespace
{

// Opens a view of each kind, warms it up, and adds its measurement without the rounds' times.
std::vector<std::unique_ptr<OffscreenView>> WarmedUpViews(
  const Scene& scene, vtkImageData* image, const OnStep& onStep, Comparison& comparison)
{
  std::vector<std::unique_ptr<OffscreenView>> views;
  for (const auto& [name, kind] : MapperKindNames())
  {
    if (!CanBlend(kind, scene.look.blend))
    {
      continue;
    }
    onStep("Warming up " + name);
    views.push_back(std::make_unique<OffscreenView>(scene, image, kind));
    OffscreenView& view = *views.back();
    Measurement measurement = {};
    measurement.kind = kind;
    measurement.firstMs = 1000.0 * view.RenderAll();
    measurement.picture = view.FloatImage();
    measurement.sampleDistanceMm = view.Pipeline().UsedSampleDistanceMm();
    measurement.error = ErrorOf(measurement.picture, comparison.truth.picture, scene.background);
    comparison.measurements.push_back(measurement);
    // FloatImage uses another framebuffer, and the first frame in the window's own one costs more.
    view.Render();
    ThrowIfVtkReportedError();
  }
  return views;
}

}

Comparison Compare(const Scene& scene, vtkImageData* image, int rounds, const PathSettings& paths,
  const OnStep& onStep)
{
  Comparison comparison = {};
  comparison.truth =
    paths.paths > 0 ? TruthByPaths(scene, image, paths, onStep) : TruthOf(scene, image, onStep);
  const auto views = WarmedUpViews(scene, image, onStep, comparison);
  comparison.openglRenderer = views.front()->DeviceName();
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
