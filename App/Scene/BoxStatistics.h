#ifndef Varimarch_Scene_BoxStatistics_h
#define Varimarch_Scene_BoxStatistics_h

#include "Scene/RegionStatistics.h"

#include <array>

class vtkImageData;

namespace varimarch
{

/// Statistics of the voxels whose centres lie in a box along the volume's axes. A box thinner than
/// a voxel counts the voxels that it passes through.
/// @param fromMm  two opposite corners
RegionStatistics StatisticsOfBox(
  const std::array<double, 3>& fromMm, const std::array<double, 3>& toMm, vtkImageData* image);

}

#endif
