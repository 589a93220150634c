#ifndef Varimarch_Benchmarks_LightMethodsBench_h
#define Varimarch_Benchmarks_LightMethodsBench_h

#include "CommandLine/Truth.h"
#include "Core/Quality/ImageError.h"
#include "LightScenes.h"

#include <optional>
#include <string>
#include <vector>

namespace varimarch
{

/// A way to compute shadows, with fixed settings.
struct LightMethod
{
  std::string name;  ///< name in tables
  std::string title; ///< a few words on what it does
  /// One of vtkComparisonMapper::Methods; empty: our mapper.
  std::optional<int> comparison = {};
  bool hasShadows = true;
  double toleranceFactor = 1.0; ///< our mapper's error tolerance, relative to that of the options
  double spreadDegrees = 0.0;   ///< vtkComparisonMapper::SpreadDegrees
  double leastTransmittance = 1.0 / 1024.0; ///< transmittance at which rays end
};

/// Ours at the error tolerance, ours without shadows, and the methods of others, whose samples and
/// slices are a voxel apart.
const std::vector<LightMethod>& LightMethods();

/// The cost and the error of a method in a scene with one light. Times are medians of all rounds.
struct LightMethodCost
{
  double firstMs = 0.0;        ///< the first frame of a new window
  double stillMs = 0.0;        ///< a frame of the same view
  double draggedMs = 0.0;      ///< a frame for which the light has turned by two degrees
  ImageError error = {};       ///< against the scene's fine image
  double lightMegabytes = 0.0; ///< memory for light alone, at most
};

/// The costs of all methods in a scene, in their order.
struct LightMethodsCase
{
  std::string scene;
  std::vector<LightMethodCost> methods;
};

/// Draws frames by each method in turn. The errors are against an image of our mapper without a
/// lattice of light, with samples FineDistanceVoxels apart.
/// @throws std::runtime_error when a mapper reports an error
LightMethodsCase MeasureLightMethods(
  const LoadedScene& loaded, const LightCostOptions& options, const OnStep& onStep);

}

#endif
