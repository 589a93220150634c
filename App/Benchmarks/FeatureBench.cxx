#include "Benchmark.h"
#include "CommandLine/Parser.h"
#include "CommandLine/Progress.h"
#include "CommandLine/SceneArguments.h"
#include "CommandLine/Truth.h"
#include "FeatureList.h"
#include "FeatureView.h"
#include "Scene/Median.h"
#include "Scene/Model/Scene.h"

#include <vtkImageData.h>
#include <vtkOpenGLGPUVolumeRayCastMapper.h>
#include <vtkSmartPointer.h>
#include <vtkVariationFieldGPUVolumeRayCastMapper.h>

#include <CLI/CLI.hpp>

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace varimarch
{

namespace
{

/// The time of a frame before a feature is switched on, with it, and after it is off again.
struct FeatureCost
{
  double beforeMs;
  double onMs;
  double afterMs;
};

/// The cost of a feature with both mappers: medians over the rounds.
struct FeatureMeasurement
{
  const Feature* feature;
  FeatureCost ours;
  FeatureCost vtk;
  std::string drawnByVtk; ///< reason why our plugin falls back to VTK's mapper; empty: it does not
  bool vtkShowsNothing;   ///< true if only VTK's image is empty; its times are then meaningless
  std::string failure;    ///< error of a mapper; empty if both have drawn the feature
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

// Draws a scene with and without a feature, alternating between the plugin's mapper and VTK's GPU
// mapper, with a moving camera. VTK's mapper takes one sample per voxel; ours chooses the sample
// distance from its error tolerance.
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

nlohmann::ordered_json ToJson(const FeatureCost& cost)
{
  return { { "beforeMs", cost.beforeMs }, { "onMs", cost.onMs }, { "afterMs", cost.afterMs } };
}

nlohmann::ordered_json ToJson(const FeatureMeasurement& measured)
{
  const Feature& feature = *measured.feature;
  return { { "name", feature.name }, { "over", feature.over }, { "isVtks", feature.isVtks },
    { "ours", ToJson(measured.ours) }, { "vtk", ToJson(measured.vtk) },
    { "drawnByVtk", measured.drawnByVtk }, { "vtkShowsNothing", measured.vtkShowsNothing },
    { "failure", measured.failure } };
}

struct FeatureOptions
{
  SceneArguments scene;
  std::string input;
  std::vector<std::string> only; ///< names of features; empty: all
  int rounds = 3;
};

void AddFeatureOptions(CLI::App& command, FeatureOptions& options)
{
  AddSceneArgument(command, options.input);
  AddLookAndPictureOptions(command, options.scene);
  command.add_option("--only", options.only, "Features to measure (default all)")
    ->delimiter(',')
    ->check(OneOf(FeatureNames()));
  AddRoundsOption(command, options.rounds);
}

bool IsWanted(const Feature& feature, const std::vector<std::string>& only)
{
  return only.empty() || std::find(only.begin(), only.end(), feature.name) != only.end();
}

void RunFeatures(const FeatureOptions& options, BenchResults& results)
{
  const auto [scene, volume] = LoadScene(options.scene, options.input);
  results.json.update({ { "volume", std::filesystem::path(options.input).filename().string() },
    { "size", scene.size }, { "rounds", options.rounds } });
  Progress progress("Measuring features");
  for (const Feature& feature : Features())
  {
    if (IsWanted(feature, options.only))
    {
      results.json["features"].push_back(ToJson(MeasureFeature(feature, scene, volume.image,
        options.rounds, [&](const std::string& step) { progress.SetActivity(step); })));
      results.Write("features up to " + feature.name);
    }
  }
}

}

Benchmark FeatureBenchmark()
{
  return MakeBenchmark("features", "Measure the cost of each feature, in our mapper and in VTK's",
    "Examples:\n"
    "  varimarch-bench features head.nii.gz -o report --size 256x256\n"
    "  varimarch-bench features head.nii.gz -o report --only clipping,isosurface",
    AddFeatureOptions, RunFeatures);
}

}
