#ifndef Varimarch_Benchmarks_SoakBench_h
#define Varimarch_Benchmarks_SoakBench_h

#include "Scene/Scene.h"
#include "Scene/VolumeLoading.h"

#include <functional>
#include <vector>

namespace varimarch
{

/// One of the equal parts of a long run.
struct SoakPart
{
  int frames;               ///< number of frames since the start of the run
  double medianMs;          ///< median time of the part's frames
  double residentMegabytes; ///< memory of the process at the end of the part
  int openFiles;            ///< open files of the process at the end of the part
  int threads;              ///< threads of the process at the end of the part
};

constexpr int SoakParts = 10;

/// Renders a scene as a long working day does: each frame is seen from another side, every tenth
/// has another look, every 50th other voxels, and every 200th other cuts.
/// @param frames  at least SoakParts
/// @param onPart  called after each part
std::vector<SoakPart> Soak(const Scene& scene, const LoadedVolume& volume, int frames,
  const std::function<void(const SoakPart&)>& onPart);

}

#endif
