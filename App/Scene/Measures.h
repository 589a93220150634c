#ifndef Varimarch_Scene_Measures_h
#define Varimarch_Scene_Measures_h

#include "Scene/Scene.h"

#include <cstdint>

class vtkImageData;

namespace varimarch
{

double LengthMm(const Distance& distance);

/// From 0 to 180; 0 where an arm has no length.
double AngleDegrees(const Angle& angle);

/// Of the voxels whose middles lie in a box; of a box thinner than a voxel, of those it goes
/// through. What is not finite counts as no voxel.
struct BoxStatistics
{
  std::int64_t voxels = 0;
  double volumeMm3 = 0.0;
  double mean = 0.0; ///< this and what follows in units of the data, 0 without voxels
  double standardDeviation = 0.0;
  double smallest = 0.0;
  double largest = 0.0;
};

BoxStatistics StatisticsOf(const MeasuredBox& box, vtkImageData* image);

}

#endif
