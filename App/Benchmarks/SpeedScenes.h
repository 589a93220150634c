#ifndef Varimarch_Benchmarks_SpeedScenes_h
#define Varimarch_Benchmarks_SpeedScenes_h

#include "Scene/Scene.h"
#include "Scene/VolumeLoading.h"

#include <string>
#include <vector>

namespace varimarch
{

/// A scene with its volume in memory.
struct LoadedScene
{
  std::string name;
  Scene scene;
  LoadedVolume volume;
};

/// The scenes of a folder of well-known volumes. Each volume is shown soft (translucent, opacity a
/// long ramp), dense (opaque within a few voxels) and as a thin peak (only the values of one
/// surface, in false colours).
struct SpeedScenes
{
  std::vector<LoadedScene> scenes;
  std::vector<std::string> missing; ///< files that the folder does not hold
};

/// @param prefixes  only scenes whose name, such as "bonsai-soft", starts with one; empty: all
/// @throws std::runtime_error when no scene is left, or a file cannot be read
SpeedScenes LoadSpeedScenes(const std::string& folder, const std::vector<std::string>& prefixes);

}

#endif
