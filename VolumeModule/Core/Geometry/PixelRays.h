#ifndef Varimarch_Core_Geometry_PixelRays_h
#define Varimarch_Core_Geometry_PixelRays_h

#include "Core/Geometry/Box.h"

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include <array>

namespace varimarch
{

/// The ray of each pixel of an image, in grid space, for any projection that a matrix can express:
/// perspective, parallel, off-axis or sheared.
///
/// Start and direction are affine in the pixel's centre (x, y), in [-1, 1]:
///   start     = h.xyz / h.w,  h = startGrid[0] + x * startGrid[1] + y * startGrid[2]
///   direction = directionGrid[0] + x * directionGrid[1] + y * directionGrid[2]
/// Rays start on the plane of constant clip depth through the nearest corner of the volume. They do
/// not start at the eye, which may be so far away that a float cannot distinguish neighbouring
/// voxels.
struct PixelRays
{
  std::array<glm::dvec4, 3> startGrid;
  std::array<glm::dvec3, 3> directionGrid; ///< away from the eye, any length
  glm::dvec4 nearPlaneGrid; ///< the dot product with (position, 1) is >= 0 beyond the near plane
  glm::dvec4 farPlaneGrid;  ///< the dot product with (position, 1) is >= 0 up to the far plane
  /// The eye in homogeneous coordinates, at infinity for a parallel projection. It is beyond the
  /// plane x = f if eyeGrid.x > f * eyeGrid.w, and likewise for y and z.
  glm::dvec4 eyeGrid;

  /// The ray through one pixel centre, x and y in [-1, 1].
  Ray At(double x, double y) const;

  /// The part of a ray, from its start on, between the near and the far plane.
  Interval BetweenPlanes(const Ray& rayGrid) const;
};

/// @param clipFromGrid  transform from grid space to OpenGL clip space, invertible
/// @param boxGrid  box of the volume
/// @throws std::invalid_argument if the matrix has no inverse
PixelRays ComputePixelRays(const glm::dmat4& clipFromGrid, const Box& boxGrid);

}

#endif
