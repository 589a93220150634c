#ifndef Varimarch_Scene_SliceGrid_h
#define Varimarch_Scene_SliceGrid_h

#include "Scene/SlicePicture.h"

#include <glm/vec3.hpp>

namespace varimarch
{

/// True for indices from the first to the last voxel along each axis. False for NaN.
/// @param extent  as in vtkImageData
bool IsWithin(const glm::dvec3& index, const int* extent);

/// The pixels of a slice in a volume, as continuous indices of its voxels.
class SliceGrid
{
public:
  SliceGrid(vtkImageData* image, const SliceRequest& request);

  /// Index at the centre of a pixel.
  glm::dvec3 IndexAt(int column, int row) const;

  /// Difference of the indices of two points that lie this far apart along the normal.
  glm::dvec3 Through(double distanceMm) const { return distanceMm * this->throughPerMm; }

  /// True for indices within the volume.
  bool Holds(const glm::dvec3& index) const { return IsWithin(index, this->extent); }

private:
  const int* extent;
  glm::dvec3 first; ///< index at the centre of the upper left pixel
  glm::dvec3 right; ///< from a pixel to the next
  glm::dvec3 down;
  glm::dvec3 throughPerMm;
};

}

#endif
