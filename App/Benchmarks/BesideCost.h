#ifndef Varimarch_Benchmarks_BesideCost_h
#define Varimarch_Benchmarks_BesideCost_h

#include "CommandLine/Truth.h"
#include "LightScenes.h"

#include <string>
#include <vector>

namespace varimarch
{

/// The cost of shadows between a volume and opaque geometry, or another volume that overlaps with
/// it. Times are medians over all frames, drawn in turn with and without it.
struct BesideCost
{
  std::string name;
  double firstMs;   ///< the first frame with it
  double withoutMs; ///< a still frame without it
  double withMs;    ///< a frame with it, still unless the name says what moves
  double factor;    ///< median of the factors of frames that follow each other
};

struct BesideCosts
{
  std::string scene;
  std::vector<BesideCost> costs;
};

/// Draws frames with and without each of the costs, alternately, in a scene with shadows of one
/// light.
/// @throws std::runtime_error when the mapper reports an error
BesideCosts MeasureBesideCosts(
  const LoadedScene& loaded, const LightCostOptions& options, const OnStep& onStep);

}

#endif
