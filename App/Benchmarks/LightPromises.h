#ifndef Varimarch_Benchmarks_LightPromises_h
#define Varimarch_Benchmarks_LightPromises_h

#include "CommandLine/Truth.h"
#include "Core/Quality/ImageError.h"
#include "LightScenes.h"

#include <string>
#include <vector>

namespace varimarch
{

/// How well an error tolerance is kept in one view of a scene with the feature.
struct LightPromise
{
  int view; ///< camera turned by this part of a circle from the first view, from 0 on
  double errorTolerance;
  ImageError error = {}; ///< against the fine image of the view
};

/// Draws a scene from several sides, all in the same light, with each of the tolerances. Images
/// have half the side, since the fine ones take long.
/// @throws std::runtime_error when the mapper reports an error
std::vector<LightPromise> MeasureLightPromises(
  const LoadedScene& loaded, const LightCostOptions& options, const OnStep& onStep);

/// The promises of a scene.
struct LightPromises
{
  std::string scene;
  std::vector<LightPromise> promises;
};

/// Two tables: how often each tolerance is kept in all scenes, and the worst view of each scene.
/// @param scenes  at least one, all with the same tolerances
std::string MarkdownOf(const std::vector<LightPromises>& scenes, const LightCostOptions& options);

}

#endif
