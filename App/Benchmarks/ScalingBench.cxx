#include "BenchScenes.h"
#include "CommandLine/Parser.h"
#include "CommandLine/Progress.h"
#include "CommandLine/SceneArguments.h"
#include "CommandLine/Truth.h"
#include "FrameCost.h"
#include "Scene/Json/SceneNames.h"
#include "Scene/Volumes/ProceduralVolume.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <iostream>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace varimarch
{

namespace
{

/// The measurements of a mapper on a volume of one size.
struct ScalingPoint
{
  int side;                              ///< side of the cube [voxels]
  std::optional<double> fetchesPerPixel; ///< see FrameCost.h
  std::optional<double> graphicsBytes;   ///< see FrameCost.h
  std::vector<FrameCost> rounds;
  FrameCost median; ///< median of the rounds
};

/// The measurements of a mapper over the sizes of one volume.
struct ScalingCurve
{
  std::string volume;
  MapperKind kind;
  std::vector<ScalingPoint> points; ///< points, smallest side first
  std::string stopped;              ///< reason why larger volumes were skipped; empty: none were
};

void AddRound(const LoadedScene& loaded, MapperKind kind, ScalingPoint& point)
{
  OffscreenView view(loaded.scene, loaded.volume.image, kind);
  point.rounds.push_back(CostOfFrames(view, loaded.scene.look));
  if (point.rounds.size() == 1)
  {
    view.Pipeline().SetLook(loaded.scene.look);
    point.graphicsBytes = GraphicsBytes(view);
    point.fetchesPerPixel = FetchesPerPixel(view);
  }
}

// Draws the volume with each curve's mapper, in alternating rounds, and adds a point to each curve.
// A curve stops when its mapper reports an error or memory runs out.
void AddScalingPoints(const LoadedScene& loaded, int side, int rounds, const OnStep& onStep,
  std::vector<ScalingCurve>& curves)
{
  std::vector<ScalingPoint> points(curves.size(), ScalingPoint{ side, {}, {}, {}, {} });
  for (int round = 1; round <= rounds; ++round)
  {
    for (std::size_t i = 0; i < curves.size(); ++i)
    {
      if (!curves[i].stopped.empty())
      {
        continue;
      }
      onStep("round " + std::to_string(round) + " of " + std::to_string(rounds));
      try
      {
        AddRound(loaded, curves[i].kind, points[i]);
      }
      catch (const std::runtime_error& problem)
      {
        curves[i].stopped = problem.what();
      }
      catch (const std::bad_alloc&)
      {
        curves[i].stopped = "memory ran out";
      }
    }
  }
  for (std::size_t i = 0; i < curves.size(); ++i)
  {
    if (curves[i].stopped.empty())
    {
      points[i].median = MedianOf(points[i].rounds);
      curves[i].points.push_back(points[i]);
    }
  }
}

nlohmann::ordered_json ToJson(const ScalingPoint& point)
{
  nlohmann::ordered_json json = { { "side", point.side }, { "median", ToJson(point.median) } };
  if (point.fetchesPerPixel)
  {
    json["fetchesPerPixel"] = *point.fetchesPerPixel;
    json["graphicsBytes"] = *point.graphicsBytes;
  }
  for (const FrameCost& cost : point.rounds)
  {
    json["rounds"].push_back(ToJson(cost));
  }
  return json;
}

nlohmann::ordered_json ToJson(const ScalingCurve& curve)
{
  nlohmann::ordered_json json = { { "volume", curve.volume },
    { "renderer", NameOf(MapperKindNames(), curve.kind) }, { "stopped", curve.stopped } };
  for (const ScalingPoint& point : curve.points)
  {
    json["points"].push_back(ToJson(point));
  }
  return json;
}

struct ScalingOptions
{
  SceneArguments scene;
  std::vector<int> sides = { 64, 128, 256, 512 }; ///< [voxels], ascending
  int rounds = 3;
};

// Adds all curves of one procedural volume, and writes the results after each point.
void AddCurves(const std::string& volume, const ScalingOptions& options, BenchResults& results)
{
  const nlohmann::ordered_json before = results.json["curves"];
  std::vector<ScalingCurve> curves = { { volume, MapperKind::Varimarch, {}, {} },
    { volume, MapperKind::VtkGpu, {}, {} } };
  for (const int side : options.sides)
  {
    const std::string text = std::to_string(side);
    const std::string input = "procedural:" + volume + ":" + text + "x" + text + "x" + text;
    const auto [scene, loaded] = LoadScene(options.scene, input);
    results.json["size"] = scene.size;
    Progress progress("Measuring " + input);
    AddScalingPoints(
      { input, scene, loaded }, side, options.rounds,
      [&](const std::string& step) { progress.SetActivity(input + ": " + step); }, curves);
    results.json["curves"] = before;
    for (const ScalingCurve& curve : curves)
    {
      results.json["curves"].push_back(ToJson(curve));
    }
    results.Write("volumes up to " + input);
  }
}

void AddScalingOptions(CLI::App& command, ScalingOptions& options)
{
  AddLookAndPictureOptions(command, options.scene);
  command
    .add_option(
      "--sides", options.sides, "Voxels along each edge, ascending (default 64,128,256,512)")
    ->delimiter(',')
    ->check(CLI::Range(2, LargestProceduralSide).description(""))
    ->type_name("VOXELS");
  AddRoundsOption(command, options.rounds);
}

void RunScaling(const ScalingOptions& options, BenchResults& results)
{
  results.json["rounds"] = options.rounds;
  for (const std::string volume : { "shells", "torso" })
  {
    AddCurves(volume, options, results);
  }
}

}

Benchmark ScalingBenchmark()
{
  return MakeBenchmark("scaling", "Measure times over the size of two procedural volumes",
    "Examples:\n"
    "  varimarch-bench scaling -o report\n"
    "  varimarch-bench scaling -o report --sides 256,512,1024 --rounds 1",
    AddScalingOptions, RunScaling);
}

}
