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
  int side;                              ///< of the cube [voxels]
  std::optional<double> fetchesPerPixel; ///< see FrameCost.h
  std::optional<double> graphicsBytes;   ///< see FrameCost.h
  std::vector<FrameCost> rounds;
  FrameCost median; ///< of the rounds
};

/// The measurements of a mapper over the sizes of one volume.
struct ScalingCurve
{
  std::string volume;
  MapperKind kind;
  std::vector<ScalingPoint> points; ///< the smallest first
  std::string stopped;              ///< why larger volumes were left out; empty: none were
};

/// Draws the volume with each curve's mapper, in alternating rounds, and adds a point to each
/// curve. A curve stops where its mapper reports an error or memory runs out.
void AddScalingPoints(const LoadedScene& loaded, int side, int rounds, const OnStep& onStep,
  std::vector<ScalingCurve>& curves);

}

#endif
