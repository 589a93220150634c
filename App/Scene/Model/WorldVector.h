#ifndef Varimarch_Scene_WorldVector_h
#define Varimarch_Scene_WorldVector_h

#include <vtkImageData.h>

#include <glm/gtc/type_ptr.hpp>
#include <glm/vec3.hpp>

#include <array>

namespace varimarch
{

// A scene stores points and directions as plain arrays; these functions convert them to vectors and
// back.

inline glm::dvec3 VectorOf(const std::array<double, 3>& numbers)
{
  return glm::make_vec3(numbers.data());
}

inline std::array<double, 3> NumbersOf(const glm::dvec3& vector)
{
  return { vector.x, vector.y, vector.z };
}

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
