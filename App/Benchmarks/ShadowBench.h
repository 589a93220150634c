#ifndef Varimarch_Benchmarks_ShadowBench_h
#define Varimarch_Benchmarks_ShadowBench_h

#include "CommandLine/Truth.h"
#include "Core/Quality/ImageError.h"
#include "ShadowScenes.h"

#include <array>
#include <string>
#include <vector>

namespace varimarch
{

/// The change between the frames of a measurement.
enum class ShadowMotion
{
  Still,
  Turning,      ///< the camera turns by a degree for each frame
  LightDragged, ///< the light turns by two degrees for each frame
};

constexpr int ShadowMotions = 3;

/// The cost of the shadows of a scene with one light, from the upper right of its camera's first
/// position. Times are medians of all rounds.
struct ShadowCase
{
  std::string scene;
  double firstMs = 0.0; ///< the first frame with shadows, which searches for its steps
  std::array<double, ShadowMotions> withoutMs = {};
  std::array<double, ShadowMotions> withMs = {};
  std::array<double, ShadowMotions> factor = {}; ///< median of the factors of the rounds
  ImageError error = {}; ///< error of the first frame with shadows, against its fine image
};

/// Draws frames with and without shadows, alternately. The error is that against an image of the
/// same mapper without a lattice of light, with samples FineDistanceVoxels apart.
/// @throws std::runtime_error when the mapper reports an error
ShadowCase MeasureShadows(
  const LoadedScene& loaded, const ShadowOptions& options, const OnStep& onStep);

/// The geometric mean of a motion's factors, over at least one scene.
double MeanFactor(const std::vector<ShadowCase>& cases, ShadowMotion motion);

}

#endif
