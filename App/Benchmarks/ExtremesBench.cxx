#include "ExtremesBench.h"

#include "Readers/VtkMessages.h"
#include "Scene/Median.h"
#include "Stages/ExtremeScenes.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace varimarch
{

namespace
{

struct Group
{
  std::string name;
  std::vector<ExtremeScene> scenes;
};

std::vector<Group> Groups()
{
  return {
    { "Materials", ExtremeMaterials() },
    { "Hard surfaces", HardSurfaces() },
    { "Scalars", ExtremeScalars() },
    { "Thin volumes", ThinShapes() },
    { "Shapes", ExtremeShapes() },
    { "Views", ExtremeViews() },
    { "Sample distances", ExtremesWithoutTolerance() },
  };
}

double MillisecondsOfFrame(VolumeStage& stage)
{
  const auto start = std::chrono::steady_clock::now();
  stage.window->Render();
  stage.window->WaitForCompletion();
  const std::chrono::duration<double, std::milli> elapsed =
    std::chrono::steady_clock::now() - start;
  return elapsed.count();
}

bool IsAnythingIn(const std::vector<float>& rgba)
{
  constexpr float Visible = 1.0f / 255.0f;
  return std::any_of(rgba.begin(), rgba.end(), [](float channel) { return channel > Visible; });
}

// VTK's mappers do not limit the number of samples along a ray.
bool WouldNeverEnd(VolumeStage& stage, MapperKind kind)
{
  constexpr double MostSamples = 1e5;
  return !IsOurs(kind) && !stage.mapper->GetAutoAdjustSampleDistances() &&
    stage.mapper->GetSampleDistance() * MostSamples < stage.image->GetLength();
}

ExtremeResult ResultOf(VolumeStage& stage, MapperKind kind, const std::vector<float>& truth)
{
  if (WouldNeverEnd(stage, kind))
  {
    return { kind, false, {}, true, false, "", 0.0 };
  }
  VtkMessages messages;
  messages.ObserveOutput();
  stage.UseMapper(kind);
  MillisecondsOfFrame(stage);
  std::vector<double> times;
  for (int frame = 0; frame < 3; ++frame)
  {
    times.push_back(MillisecondsOfFrame(stage));
  }
  const std::vector<float> drawn = stage.Draw();
  const bool isFinite =
    std::all_of(drawn.begin(), drawn.end(), [](float channel) { return std::isfinite(channel); });
  return { kind, true, CompareImages(drawn.data(), truth.data(), truth.size() / 4), isFinite,
    IsAnythingIn(truth) && !IsAnythingIn(drawn), messages.FirstSentence(), Median(times) };
}

bool IsWanted(const std::string& name, const std::vector<std::string>& only)
{
  return only.empty() ||
    std::any_of(only.begin(), only.end(),
      [&](const std::string& start) { return name.compare(0, start.size(), start) == 0; });
}

std::vector<ExtremeResult> ResultsOf(const ExtremeScene& extreme, vtkHeadlessRenderWindow* window)
{
  std::vector<ExtremeResult> results;
  const std::vector<float> truth = StageOf(extreme, ExtremesSide, window)->Truth();
  for (const MapperKind kind : ExtremeMappers())
  {
    // A new stage for each, so that none inherits what another has built.
    results.push_back(ResultOf(*StageOf(extreme, ExtremesSide, window), kind, truth));
  }
  return results;
}

}

const std::vector<MapperKind>& ExtremeMappers()
{
  static const std::vector<MapperKind> kinds = { MapperKind::Varimarch,
    MapperKind::VarimarchShaders, MapperKind::VtkGpu, MapperKind::VtkCpu };
  return kinds;
}

void MeasureExtremes(const std::vector<std::string>& only, const OnStep& onStep,
  const std::function<void(const std::vector<ExtremeMeasurement>&)>& onResult)
{
  std::vector<ExtremeMeasurement> measurements;
  vtkNew<vtkHeadlessRenderWindow> window;
  for (const Group& group : Groups())
  {
    for (const ExtremeScene& extreme : group.scenes)
    {
      if (IsWanted(extreme.name, only))
      {
        onStep(extreme.name);
        measurements.push_back({ group.name, extreme.name, ResultsOf(extreme, window) });
        onResult(measurements);
      }
    }
  }
}

}
