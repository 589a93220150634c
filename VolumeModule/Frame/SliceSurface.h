#ifndef Varimarch_Frame_SliceSurface_h
#define Varimarch_Frame_SliceSurface_h

#include "Frame/VolumeGeometry.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

class vtkImplicitFunction;

namespace varimarch
{

/// A surface of second degree: dot(p, matrix * p) = 0 on it, with p = (position - centre, 1), in
/// grid space.
struct SliceSurface
{
  glm::dmat4 matrix = glm::dmat4(0.0); ///< Symmetric; its largest entry is 1 or -1.
  glm::dvec3 centerGrid = glm::dvec3(0.0);
};

/// The surface of an implicit function of the world, which is sampled at a few points of the
/// volume.
/// @throws std::runtime_error if the function is not of second degree there
SliceSurface SliceSurfaceOf(vtkImplicitFunction* function, const VolumeGeometry& geometry);

}

#endif
