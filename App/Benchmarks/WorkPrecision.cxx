#include "WorkPrecision.h"

#include "CommandLine/Results.h"
#include "CommandLine/VtkMessages.h"
#include "MethodView.h"
#include "Scene/Median.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace varimarch
{

namespace
{

/// Measures one method on a scene.
struct Runner
{
  WorkCurve curve;
  std::unique_ptr<MethodView> view;

  /// The time of a frame, drawn after another one that built what the setting needs [s].
  double SecondsOf(const BenchSetting& setting)
  {
    this->view->SetOptions(setting.options);
    this->view->Offscreen().Render();
    return this->view->Offscreen().Render();
  }
};

bool HoldsEightBitsOnly(vtkImageData* picture)
{
  // This is far above the error of rounding n / 255 to a float.
  constexpr double Slack = 1e-4;
  const auto* channels = static_cast<const float*>(picture->GetScalarPointer());
  return std::all_of(channels, channels + 4 * picture->GetNumberOfPoints(),
    [](float channel)
    {
      const double level = 255.0 * channel;
      return std::abs(level - std::round(level)) < Slack;
    });
}

// The RMSE of rounding alone. An 8-bit image has a smaller error only by chance.
double EightBitRmse(vtkImageData* truth)
{
  const auto* channels = static_cast<const float*>(truth->GetScalarPointer());
  const vtkIdType count = 4 * truth->GetNumberOfPoints();
  double sum = 0.0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double level = 255.0 * channels[i];
    sum += (level - std::round(level)) * (level - std::round(level));
  }
  return std::sqrt(sum / double(count));
}

// Draws one setting, measures its error, and returns the time of a frame [s].
double AddPoint(Runner& runner, const BenchSetting& setting, const WorkPrecision& result)
{
  constexpr double NearOneVoxel = 0.99; // VTK's mappers round distances to float
  const double seconds = runner.SecondsOf(setting);
  MethodView& view = *runner.view;
  const auto picture = view.Offscreen().FloatImage();
  ThrowIfVtkReportedError();
  WorkCurve& curve = runner.curve;
  curve.eightBits = HoldsEightBitsOnly(picture) && (curve.points.empty() || curve.eightBits);
  curve.points.push_back({ setting, view.UsedSampleDistanceMm(), view.EstimatedError(),
    ErrorOf(picture, result.truth.picture, result.scene.background), view.Fetches(), view.Bytes(),
    {}, 0.0 });
  if (!curve.picture || VoxelsOf(result, curve.points.back()) >= NearOneVoxel)
  {
    curve.picture = picture;
    curve.shown = curve.points.size() - 1;
  }
  return seconds;
}

Runner StartedRunner(const BenchRun& run, const WorkPrecision& result,
  const MeasuringOptions& options, const OnStep& onStep)
{
  Runner runner = { { run.method, {}, {}, false, 0, nullptr, {} },
    std::make_unique<MethodView>(run.method, result.scene, result.volume.image) };
  double seconds = 0.0;
  for (const BenchSetting& setting : run.settings)
  {
    if (seconds > options.longestSeconds)
    {
      runner.curve.skipped = setting.label + " and finer: an image at " +
        runner.curve.points.back().setting.label + " took " + Fixed(seconds, 1) +
        " s, more than the " + Fixed(options.longestSeconds, 1) + " s allowed";
      break;
    }
    onStep(result.name + ": errors of " + run.method.name + " at " + setting.label);
    seconds = AddPoint(runner, setting, result);
  }
  return runner;
}

// The setting that a curve's picture shows, of all methods on the same orbit.
void MeasureOrbits(
  std::vector<Runner>& runners, const WorkPrecision& result, int frames, const OnStep& onStep)
{
  std::vector<MethodView*> views;
  for (Runner& runner : runners)
  {
    runner.view->SetOptions(runner.curve.points[runner.curve.shown].setting.options);
    views.push_back(runner.view.get());
  }
  const std::vector<OrbitChange> changes = ChangesInOrbit(views, result.scene, result.volume.image,
    frames, [&](const std::string& step) { onStep(result.name + ": " + step); });
  for (std::size_t i = 0; i < runners.size(); ++i)
  {
    runners[i].curve.orbit = changes[i];
  }
}

}

WorkPrecision MeasureRuns(const std::string& name, const Scene& scene, const LoadedVolume& volume,
  const std::vector<BenchRun>& runs, const MeasuringOptions& options, const OnStep& onStep)
{
  WorkPrecision result = { name, scene, volume, {}, 0.0, {}, {} };
  result.truth =
    TruthOf(scene, volume.image, [&](const std::string& step) { onStep(name + ": " + step); });
  result.eightBitRmse = EightBitRmse(result.truth.picture);

  std::vector<Runner> runners;
  for (const BenchRun& run : runs)
  {
    runners.push_back(StartedRunner(run, result, options, onStep));
  }
  for (int round = 1; round <= options.rounds; ++round)
  {
    for (Runner& runner : runners)
    {
      onStep(name + ": times of " + runner.curve.method.name + ", round " + std::to_string(round) +
        " of " + std::to_string(options.rounds));
      for (WorkPoint& point : runner.curve.points)
      {
        point.roundsMs.push_back(1000.0 * runner.SecondsOf(point.setting));
      }
    }
  }
  if (options.orbitFrames > 0)
  {
    MeasureOrbits(runners, result, options.orbitFrames, onStep);
  }
  ThrowIfVtkReportedError();
  for (Runner& runner : runners)
  {
    for (WorkPoint& point : runner.curve.points)
    {
      point.medianMs = Median(point.roundsMs);
    }
    result.openglRenderer = runner.view->Offscreen().DeviceName();
    result.curves.push_back(runner.curve);
  }
  return result;
}

const WorkCurve* CurveOf(const WorkPrecision& scene, const std::string& method)
{
  const auto found = std::find_if(scene.curves.begin(), scene.curves.end(),
    [&](const WorkCurve& curve) { return curve.method.name == method; });
  return found == scene.curves.end() ? nullptr : &*found;
}

double VoxelsOf(const WorkPrecision& scene, const WorkPoint& point)
{
  return point.sampleDistanceMm / VoxelMm(scene.volume.image);
}

std::optional<double> MillisecondsAtError(
  const WorkCurve& curve, double ImageError::*measure, double error)
{
  std::optional<double> best;
  const auto offer = [&](double milliseconds)
  { best = best ? std::min(*best, milliseconds) : milliseconds; };
  for (std::size_t i = 0; i < curve.points.size(); ++i)
  {
    const double right = curve.points[i].error.light.*measure;
    if (right <= error)
    {
      offer(curve.points[i].medianMs);
    }
    const double left = i == 0 ? right : curve.points[i - 1].error.light.*measure;
    if (left > error && right < error)
    {
      const double part = std::log(left / error) / std::log(left / right);
      const double leftMs = curve.points[i - 1].medianMs;
      offer(leftMs * std::pow(curve.points[i].medianMs / leftMs, part));
    }
  }
  return best;
}

}
