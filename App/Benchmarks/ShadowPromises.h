#ifndef Varimarch_Benchmarks_ShadowPromises_h
#define Varimarch_Benchmarks_ShadowPromises_h

#include "CommandLine/Truth.h"
#include "Core/Quality/ImageError.h"
#include "ShadowScenes.h"

#include <string>
#include <vector>

namespace varimarch
{

/// How well an error tolerance is kept in one view of a scene with shadows.
struct ShadowPromise
{
  int view; ///< camera turned by this part of a circle from the first view, from 0 on
  double errorTolerance;
  ImageError error = {}; ///< against the fine image of the view
};

/// Draws a scene from several sides, all in the same light, with each of the tolerances. Images
/// have half the side, since the fine ones take long.
/// @throws std::runtime_error when the mapper reports an error
std::vector<ShadowPromise> MeasureShadowPromises(
  const LoadedScene& loaded, const ShadowOptions& options, const OnStep& onStep);

/// The promises of a scene.
struct ShadowPromises
{
  std::string scene;
  std::vector<ShadowPromise> promises;
};

/// Two tables: how often each tolerance is kept in all scenes, and the worst view of each scene.
/// @param scenes  at least one, all with the same tolerances
std::string MarkdownOf(const std::vector<ShadowPromises>& scenes, const ShadowOptions& options);

}

#endif
