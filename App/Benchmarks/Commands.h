#ifndef Varimarch_Benchmarks_Commands_h
#define Varimarch_Benchmarks_Commands_h

#include "CommandLine/SceneArguments.h"
#include "LightCost.h"
#include "PublishedScenes.h"
#include "SpeedBench.h"
#include "WorkPrecision.h"

#include <optional>
#include <string>
#include <vector>

namespace CLI
{
class App;
}

namespace varimarch
{

/// Arguments that all benchmarks have in common.
struct ReportArguments
{
  std::string commandText; ///< the whole command line, for the results
  std::string outputFolder;
  std::string jsonPath; ///< another file for the results; empty: none
};

struct WorkPrecisionArguments
{
  ReportArguments report;
  SceneArguments scene;
  std::vector<std::string> inputs;
  std::vector<std::string> methods; ///< empty: all
  MeasuringOptions options;
};

struct PublishedArguments
{
  ReportArguments report;
  PublishedOptions options;
};

/// The scenes that a benchmark draws.
struct BenchSceneArguments
{
  std::vector<std::string> inputs;
  std::string volumes;           ///< folder of well-known volumes; empty: none
  std::vector<std::string> only; ///< prefixes of scene names; empty: all scenes
};

/// @throws UsageError when there are none
/// @throws std::runtime_error when a file cannot be read
SpeedScenes LoadBenchScenes(const BenchSceneArguments& arguments);

struct SpeedArguments
{
  ReportArguments report;
  BenchSceneArguments scenes;
  SpeedOptions options;
};

struct LightCostArguments
{
  ReportArguments report;
  BenchSceneArguments scenes;
  LightCostOptions options;
};

struct ScalingArguments
{
  ReportArguments report;
  SceneArguments scene;
  std::vector<int> sides = { 64, 128, 256, 512 }; ///< [voxels], ascending
  int rounds = 3;
};

struct FeatureArguments
{
  ReportArguments report;
  SceneArguments scene;
  std::string input;
  std::vector<std::string> only; ///< names of features; empty: all
  int rounds = 3;
};

struct ExtremesArguments
{
  std::string commandText; ///< the whole command line, for the results
  std::string outputFolder;
  std::vector<std::string> only; ///< beginnings of the names of scenes; empty: all
};

struct OrderArguments
{
  ReportArguments report;
  int side = 128; ///< height and width of the images [pixels], a multiple of 8
};

struct ReferencesArguments
{
  std::string outputFolder;
  std::optional<MapperKind> renderer; ///< the mapper that draws; empty: the reference
};

struct SoakArguments
{
  ReportArguments report;
  SceneArguments scene;
  std::string input;
  int frames = 20000; ///< at least SoakParts
};

struct TimesArguments
{
  ReportArguments report;
  SceneArguments scene;
  std::string input;
  int times = 20;
  int frames = 1000;
};

struct ShaderCostArguments
{
  ReportArguments report;
  SceneArguments scene;
  std::string input;
};

/// Run the benchmarks. Each measures, writes its report after every step, so that an interrupted
/// run keeps its results, and prints a summary.
/// @throws UsageError when the arguments do not fit together
/// @throws std::runtime_error when a file cannot be read or written, or a mapper reports an error
void RunWorkPrecision(const WorkPrecisionArguments& arguments);
void RunPublished(const PublishedArguments& arguments);
void RunSpeed(const SpeedArguments& arguments);
void RunLightCost(const LightCostArguments& arguments);
void RunBesideCost(const LightCostArguments& arguments);
void RunLightMethods(const LightCostArguments& arguments);
void RunScaling(const ScalingArguments& arguments);
void RunFeatures(const FeatureArguments& arguments);
void RunShaderCosts(const ShaderCostArguments& arguments);
void RunExtremes(const ExtremesArguments& arguments);
void RunOrder(const OrderArguments& arguments);
void RunReferences(const ReferencesArguments& arguments);
void RunSoak(const SoakArguments& arguments);
void RunTimes(const TimesArguments& arguments);

/// Adds the subcommands that fill these arguments and run.
void AddCommands(CLI::App& program, const std::string& commandText);

}

#endif
