#ifndef Varimarch_Benchmarks_ScalingBench_h
#define Varimarch_Benchmarks_ScalingBench_h

#include "CommandLine/Truth.h"
#include "FrameCost.h"
#include "SpeedScenes.h"

#include <optional>
#include <string>
#include <vector>

namespace varimarch
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

/// Draws the volume with each curve's mapper, in alternating rounds, and adds a point to each
/// curve. A curve stops when its mapper reports an error or memory runs out.
void AddScalingPoints(const LoadedScene& loaded, int side, int rounds, const OnStep& onStep,
  std::vector<ScalingCurve>& curves);

}

#endif
