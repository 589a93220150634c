#ifndef Varimarch_Scene_FlatRegion_h
#define Varimarch_Scene_FlatRegion_h

#include "Scene/RegionStatistics.h"

#include <glm/vec3.hpp>

#include <vector>

class vtkImageData;

namespace varimarch
{

/// An outline's area times the normal of its plane [mm²]. Zero for fewer than three points.
glm::dvec3 AreaVector(const std::vector<glm::dvec3>& outlineMm);

/// Statistics of the pixels whose centres lie in an outline, by the even-odd rule. If the outline's
/// plane faces along an axis of the volume, the pixels are the voxels of the nearest slice.
/// Otherwise they lie in the plane as far apart as the nearest voxels of the volume, one of them at
/// the middle of the outline's points, and have linearly interpolated values. Pixels outside the
/// volume are left out. The statistics count pixels as voxels.
RegionStatistics StatisticsOfFlatRegion(
  const std::vector<glm::dvec3>& outlineMm, vtkImageData* image);

}

#endif
