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

/// The scenes made from a folder of well-known volumes. Each volume is drawn soft (translucent,
/// with a long ramp of opacity), dense (opaque within a few voxels) and as a thin peak (only the
/// values of one surface, in false colours).
struct SpeedScenes
{
  std::vector<LoadedScene> scenes;
  std::vector<std::string> missing; ///< files that are not in the folder
};

/// @param prefixes  beginnings of the names of scenes to load, such as "bonsai"; empty: all
/// @throws std::runtime_error when no scene is left, or a file cannot be read
SpeedScenes LoadSpeedScenes(const std::string& folder, const std::vector<std::string>& prefixes);

}

#endif
