#ifndef Varimarch_Scene_ScenePicking_h
#define Varimarch_Scene_ScenePicking_h

#include "Scene/Scene.h"

#include <array>
#include <optional>

class vtkImageData;

namespace varimarch
{

/// Where a ray meets what a scene shows, in world space [mm]: of a composite the point at which
/// half of the light is gone, of other blends that of the largest opacity; none where there is
/// no such point. By samples a quarter of the smallest spacing apart.
/// @param from, to  world space [mm]
/// @param mask      what scissors leave, see Scissors.h; may be null
std::optional<std::array<double, 3>> PointSeen(const Scene& scene, vtkImageData* image,
  const std::array<double, 3>& from, const std::array<double, 3>& to, vtkImageData* mask = nullptr);

/// The value at a point in world space, between voxels; none outside of the volume.
std::optional<double> ValueAt(vtkImageData* image, const std::array<double, 3>& pointMm);

}

#endif
