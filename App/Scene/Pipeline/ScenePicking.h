#ifndef Varimarch_Scene_ScenePicking_h
#define Varimarch_Scene_ScenePicking_h

#include "Scene/Model/Scene.h"

#include <array>
#include <optional>

class vtkImageData;

namespace varimarch
{

/// The point where a ray meets the visible part of a scene, in world space [mm]. For composites it
/// is where half of the light is absorbed, for other blend modes where the opacity is largest.
/// Empty if there is no such point. Samples are a quarter of the smallest spacing apart.
/// @param from, to  ends of the ray in world space [mm]
/// @param mask      the part that the scissors keep, see SceneCuts.h; may be null
std::optional<std::array<double, 3>> PointSeen(const Scene& scene, vtkImageData* image,
  const std::array<double, 3>& from, const std::array<double, 3>& to, vtkImageData* mask = nullptr);

/// True if the scene absorbs at least half of the light between the eye and a point, both in world
/// space [mm]. A point on a surface is not hidden by it, and projections hide nothing.
bool IsHidden(const Scene& scene, vtkImageData* image, const std::array<double, 3>& eye,
  const std::array<double, 3>& point, vtkImageData* mask = nullptr);

/// The interpolated value at a point in world space; empty outside the volume.
std::optional<double> ValueAt(vtkImageData* image, const std::array<double, 3>& pointMm);

}

#endif
