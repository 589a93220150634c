#ifndef Varimarch_Scene_SceneVolumes_h
#define Varimarch_Scene_SceneVolumes_h

#include "Scene/Scene.h"

#include <optional>

namespace varimarch
{

// The volumes of a scene by their numbers: 0 is the first, i the overlay i - 1.

inline int VolumeCount(const Scene& scene)
{
  return 1 + int(scene.overlays.size());
}

inline const std::optional<SceneLabels>& SceneLabelsOf(const Scene& scene, int volume)
{
  return volume == 0 ? scene.labels : scene.overlays[volume - 1].labels;
}

inline std::optional<SceneLabels>& SceneLabelsOf(Scene& scene, int volume)
{
  return volume == 0 ? scene.labels : scene.overlays[volume - 1].labels;
}

inline const VolumeSource& VolumeSourceOf(const Scene& scene, int volume)
{
  return volume == 0 ? scene.volume : scene.overlays[volume - 1].source;
}

/// The first volume is always at its own place.
inline Placement PlacementOf(const Scene& scene, int volume)
{
  return volume == 0 ? Placement() : scene.overlays[volume - 1].placement;
}

}

#endif
