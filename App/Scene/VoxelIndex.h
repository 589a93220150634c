#ifndef Varimarch_Scene_VoxelIndex_h
#define Varimarch_Scene_VoxelIndex_h

#include <vtkImageData.h>

#include <glm/vec3.hpp>

namespace varimarch
{

/// Index of a point in the extent of an image. Between voxels it has a fraction, outside of the
/// image it is beyond the extent.
/// @param pointMm  in world space [mm]
inline glm::dvec3 VoxelIndexOf(const glm::dvec3& pointMm, vtkImageData* image)
{
  glm::dvec3 index;
  image->TransformPhysicalPointToContinuousIndex(&pointMm.x, &index.x);
  return index;
}

}

#endif
