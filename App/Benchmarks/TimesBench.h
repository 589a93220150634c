#ifndef Varimarch_Benchmarks_TimesBench_h
#define Varimarch_Benchmarks_TimesBench_h

#include "Scene/Scene.h"
#include "Scene/VolumeLoading.h"

#include <functional>

namespace varimarch
{

/// The cost of voxels that are new in each frame, as when the times of a scan are played.
struct TimesCost
{
  int frames = 0;
  double stillMs = 0.0; ///< median time of a frame of the same voxels from another side
  double newMs = 0.0;   ///< median time of a frame of voxels that were not drawn before
  double againMs = 0.0; ///< median time of a frame of other voxels that were; 0 without any
  double fieldMs = 0.0; ///< median time for the field of new voxels, a part of the former
  double residentMegabytesAtFirst =
    0.0; ///< memory of the process when each time, or frame, was drawn once
  double residentMegabytesAtEnd = 0.0;
  double movingMs = 0.0;        ///< median time of a frame while somebody plays, as in the viewer
  double movingRaysApart = 1.0; ///< median distance between the rays of these frames [pixels]
};

/// Renders a volume at several times, each of which differs from the last by the values of a few
/// rows of voxels that move.
/// @param times  at least 2
/// @param onFrame  called after each frame with its number
TimesCost CostOfTimes(const Scene& scene, const LoadedVolume& volume, int times, int frames,
  const std::function<void(int)>& onFrame);

}

#endif
