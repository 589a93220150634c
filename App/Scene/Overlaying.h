#ifndef Varimarch_Scene_Overlaying_h
#define Varimarch_Scene_Overlaying_h

#include "Scene/Scene.h"
#include "Scene/VolumeLoading.h"

namespace varimarch
{

class ImageStatistics;

/// Whether two volumes are in the same space, by the frames of reference of their files.
enum class CommonSpace
{
  Same,
  Different,
  Unknown, ///< a file does not say
};

CommonSpace SpaceOf(const LoadedVolume& first, const LoadedVolume& other);

/// A volume to draw over another, with the look that suits it: PET is hot in 3D and in slices, and
/// other volumes have the composite that resembles their suggested preset.
OverlaidVolume OverlayOf(
  const VolumeSource& source, const LoadedVolume& volume, const ImageStatistics& statistics);

}

#endif
