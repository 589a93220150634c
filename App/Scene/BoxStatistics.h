#ifndef Varimarch_Scene_BoxStatistics_h
#define Varimarch_Scene_BoxStatistics_h

#include "Scene/RegionStatistics.h"

#include <array>

class vtkImageData;

namespace varimarch
{

/// Statistics of the voxels whose centres lie in a box along the axes of a volume. A box thinner
/// than the distance of the voxels counts those nearest to its middle.
/// @param fromMm  two opposite corners
/// @param grid    the volume along whose axes the box lies
/// @param voxels  the volume whose voxels are counted, the same or one over it
RegionStatistics StatisticsOfBox(const std::array<double, 3>& fromMm,
  const std::array<double, 3>& toMm, vtkImageData* grid, vtkImageData* voxels);

}

#endif
