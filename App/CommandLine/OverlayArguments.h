#ifndef Varimarch_CommandLine_OverlayArguments_h
#define Varimarch_CommandLine_OverlayArguments_h

#include "Scene/Pipeline/SceneOverlays.h"
#include "Scene/Volumes/VolumeLoading.h"

#include <string>
#include <vector>

namespace varimarch
{

/// Reads the volumes over the first one, those of the scene and then further files, which are added
/// to the scene with the looks that suit them. Warns of volumes in another space than the first.
/// @return the image and the labels of each of the scene's overlays
/// @throws UsageError for too many
/// @throws std::runtime_error when a file cannot be read
std::vector<OverlayVoxels> LoadOverlaysReporting(
  const std::vector<std::string>& paths, const LoadedVolume& first, Scene& scene);

}

#endif
