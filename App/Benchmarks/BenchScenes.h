#ifndef Varimarch_Benchmarks_BenchScenes_h
#define Varimarch_Benchmarks_BenchScenes_h

#include "Benchmark.h"
#include "CommandLine/Truth.h"
#include "Scene/Model/Scene.h"
#include "Scene/Volumes/VolumeLoading.h"

#include <functional>
#include <string>
#include <vector>

namespace varimarch
{

/// A scene with its volume in memory.
struct LoadedScene
{
  std::string name;
  Scene scene;
  LoadedVolume volume;
};

/// The scenes that a benchmark draws. Each volume of a folder of well-known volumes is drawn soft
/// (translucent, with a long ramp of opacity), dense (opaque within a few voxels) and as a thin
/// peak (only the values of one surface, in false colours).
struct BenchSceneOptions
{
  std::vector<std::string> inputs;
  std::string volumes;           ///< folder of well-known volumes; empty: none
  std::vector<std::string> only; ///< prefixes of scene names, such as "bonsai"; empty: all scenes
};

/// Adds SCENES, --volumes and --only.
void AddBenchSceneOptions(CLI::App& command, BenchSceneOptions& options);

/// Measures each of the scenes, adds to the results those of its volumes that are not in the
/// folder, and writes the results after each scene.
/// @param measure  adds what it measures to the results
/// @throws UsageError when there are no scenes
/// @throws std::runtime_error when no scene is left, or a file cannot be read or written
void MeasureSceneByScene(const BenchSceneOptions& options, BenchResults& results,
  const std::function<void(const LoadedScene&, const OnStep&)>& measure);

}

#endif
