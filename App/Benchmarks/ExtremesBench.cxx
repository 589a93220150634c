#include "Benchmark.h"
#include "CommandLine/PictureError.h"
#include "CommandLine/Progress.h"
#include "Core/Quality/ImageError.h"
#include "Readers/Parsing/VtkMessages.h"
#include "Scene/Json/SceneNames.h"
#include "Scene/Median.h"
#include "Scene/Model/Scene.h"
#include "Stages/ExtremeScenes.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <vector>

namespace varimarch
{

namespace
{

/// Height and width of the images [pixels]: those of the tests of the same scenes.
constexpr int ExtremesSide = 48;

/// A mapper's image of an extreme scene.
struct ExtremeResult
{
  MapperKind kind;
  bool wasTried;       ///< false for VTK's mappers where they would march for hours
  ImageError error;    ///< [1/255]
  bool isFinite;       ///< true if all channels are finite
  bool isEmpty;        ///< true if nothing is drawn although there is something to see
  std::string message; ///< first error or warning of VTK or of the mapper; empty: none
  double medianMs;     ///< median time of three frames after the first
};

// Our mapper by packets and by shaders, and VTK's GPU and fixed-point mappers.
const std::vector<MapperKind>& ExtremeMappers()
{
  static const std::vector<MapperKind> kinds = { MapperKind::Varimarch,
    MapperKind::VarimarchShaders, MapperKind::VtkGpu, MapperKind::VtkCpu };
  return kinds;
}

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

nlohmann::ordered_json ToJson(const ExtremeResult& result)
{
  return { { "mapper", NameOf(MapperKindNames(), result.kind) }, { "tried", result.wasTried },
    { "error255", ToJson(result.error) }, { "finite", result.isFinite },
    { "empty", result.isEmpty }, { "message", result.message }, { "medianMs", result.medianMs } };
}

nlohmann::ordered_json ToJson(const std::vector<ExtremeResult>& results)
{
  nlohmann::ordered_json json;
  for (const ExtremeResult& result : results)
  {
    json.push_back(ToJson(result));
  }
  return json;
}

struct ExtremesOptions
{
  std::vector<std::string> only; ///< beginnings of the names of scenes; empty: all
};

void AddExtremesOptions(CLI::App& command, ExtremesOptions& options)
{
  command
    .add_option("--only", options.only, "Draw only scenes whose names start with one of these")
    ->delimiter(',')
    ->type_name("NAMES");
}

// Draws every scene of ExtremeScenes.h with every mapper at its defaults, and compares each image
// with the reference integrator's.
void RunExtremes(const ExtremesOptions& options, BenchResults& results)
{
  results.json["side"] = ExtremesSide;
  Progress progress("Measuring extreme scenes");
  vtkNew<vtkHeadlessRenderWindow> window;
  for (const Group& group : Groups())
  {
    for (const ExtremeScene& extreme : group.scenes)
    {
      if (IsWanted(extreme.name, options.only))
      {
        progress.SetActivity(extreme.name);
        results.json["scenes"].push_back({ { "group", group.name }, { "name", extreme.name },
          { "results", ToJson(ResultsOf(extreme, window)) } });
        results.Write("scenes up to " + extreme.name);
      }
    }
  }
}

}

Benchmark ExtremesBenchmark()
{
  return MakeBenchmark("extremes",
    "Measure errors and times of stiff and extreme scenes, in our mapper and in VTK's",
    "Example:\n  varimarch-bench extremes -o extremes", AddExtremesOptions, RunExtremes);
}

}
