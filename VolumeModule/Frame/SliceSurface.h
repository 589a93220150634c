#ifndef Varimarch_Frame_SliceSurface_h
#define Varimarch_Frame_SliceSurface_h

#include "Frame/VolumeGeometry.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

class vtkImplicitFunction;

namespace varimarch
{

/// A surface of second degree: where dot(p, matrix * p) = 0, with p = (position - centre, 1), in
/// grid space.
struct SliceSurface
{
  glm::dmat4 matrix = glm::dmat4(0.0); ///< symmetric; its largest entry is 1 or -1
  glm::dvec3 centerGrid = glm::dvec3(0.0);
};

/// Of an implicit function of the world, which is read at a few points of the volume.
/// @throws std::runtime_error when it is not of second degree there
SliceSurface SliceSurfaceOf(vtkImplicitFunction* function, const VolumeGeometry& geometry);

}

#endif
