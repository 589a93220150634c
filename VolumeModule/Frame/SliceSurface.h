#ifndef Varimarch_Frame_SliceSurface_h
#define Varimarch_Frame_SliceSurface_h

#include "Frame/VolumeGeometry.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <tuple>

class vtkImplicitFunction;

namespace varimarch
{

/// A quadric in grid space: the points with dot(p, matrix * p) = 0, where
/// p = (position - centre, 1).
struct SliceSurface
{
  glm::dmat4 matrix = glm::dmat4(0.0); ///< Symmetric; its largest entry is 1 or -1.
  glm::dvec3 centerGrid = glm::dvec3(0.0);
};

inline auto FieldsOf(const SliceSurface& surface)
{
  const auto& [matrix, centerGrid] = surface;
  return std::tie(matrix, centerGrid);
}

/// The surface of an implicit function in world space, fitted to a few of its values in the volume.
/// @throws std::runtime_error if the function is not of second degree in the volume
SliceSurface SliceSurfaceOf(vtkImplicitFunction* function, const VolumeGeometry& geometry);

}

#endif
