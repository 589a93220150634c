#ifndef Varimarch_Benchmarks_LightCost_h
#define Varimarch_Benchmarks_LightCost_h

#include "CommandLine/Truth.h"
#include "Core/Quality/ImageError.h"
#include "LightScenes.h"

#include <array>
#include <string>
#include <vector>

namespace varimarch
{

/// The change between the frames of a measurement.
enum class LightMotion
{
  Still,
  Turning,      ///< the camera turns by a degree for each frame
  LightDragged, ///< the light turns by two degrees, and occlusion weakens, for each frame
};

constexpr int LightMotions = 3;

/// The cost of a feature in a scene with one light, from the upper right of its camera's first
/// position. Times are medians of all rounds.
struct LightCost
{
  std::string scene;
  double firstMs = 0.0; ///< the first frame with it, which searches for its steps
  std::array<double, LightMotions> withoutMs = {};
  std::array<double, LightMotions> withMs = {};
  std::array<double, LightMotions> factor = {}; ///< median of the factors of the rounds
  ImageError error = {}; ///< error of the first frame with it, against its fine image
};

/// Draws frames with and without the feature, alternately. The error is that against an image of
/// the same mapper without a lattice of light, with samples FineDistanceVoxels apart.
/// @throws std::runtime_error when the mapper reports an error
LightCost MeasureLightCost(
  const LoadedScene& loaded, const LightCostOptions& options, const OnStep& onStep);

/// The geometric mean of a motion's factors, over at least one scene.
double MeanFactor(const std::vector<LightCost>& cases, LightMotion motion);

}

#endif
