#ifndef Varimarch_Scene_Measures_h
#define Varimarch_Scene_Measures_h

#include "Scene/RegionStatistics.h"
#include "Scene/Scene.h"

class vtkImageData;

namespace varimarch
{

double LengthMm(const Distance& distance);

/// Angle [degrees], from 0 to 180; 0 if an arm has no length.
double AngleDegrees(const Angle& angle);

/// Statistics of the voxels whose centres lie in a box. A box thinner than a voxel counts the
/// voxels that it passes through.
RegionStatistics StatisticsOf(const MeasuredBox& box, vtkImageData* image);

}

#endif
