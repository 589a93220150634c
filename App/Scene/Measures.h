#ifndef Varimarch_Scene_Measures_h
#define Varimarch_Scene_Measures_h

#include "Scene/Scene.h"

#include <cstdint>

class vtkImageData;

namespace varimarch
{

double LengthMm(const Distance& distance);

/// Angle [degrees], from 0 to 180; 0 if an arm has no length.
double AngleDegrees(const Angle& angle);

/// Statistics of the voxels whose centres lie in a box. A box thinner than a voxel counts the
/// voxels that it passes through. Values that are not finite are left out.
struct BoxStatistics
{
  std::int64_t voxels = 0;
  double volumeMm3 = 0.0;
  double mean = 0.0; ///< in units of the data; 0 if the box holds no voxels
  double standardDeviation = 0.0;
  double smallest = 0.0;
  double largest = 0.0;
};

BoxStatistics StatisticsOf(const MeasuredBox& box, vtkImageData* image);

}

#endif
