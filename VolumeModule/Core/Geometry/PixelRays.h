#ifndef Varimarch_Core_Geometry_PixelRays_h
#define Varimarch_Core_Geometry_PixelRays_h

#include "Core/Geometry/Box.h"

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include <array>

namespace varimarch
{

/// The ray of every pixel of a picture, in grid space, for any projection a matrix can express:
/// perspective, parallel, off-axis, sheared.
///
/// With (x, y) the pixel's centre in [-1, 1], start and direction are affine:
///   start     = h.xyz / h.w,  h = startGrid[0] + x * startGrid[1] + y * startGrid[2]
///   direction = directionGrid[0] + x * directionGrid[1] + y * directionGrid[2]
/// Rays start on the plane of clip depth that touches the nearest corner of the volume, not at the
/// eye, which may be so far away that a float could not tell one voxel from the next.
struct PixelRays
{
  std::array<glm::dvec4, 3> startGrid;
  std::array<glm::dvec3, 3> directionGrid; ///< away from the eye, any length
  glm::dvec4 nearPlaneGrid;                ///< dot(plane, (position, 1)) >= 0 beyond the near plane
  glm::dvec4 farPlaneGrid;                 ///< and before the far plane
  /// Where the rays come from, homogeneous, at infinity in a parallel projection: the eye is beyond
  /// the plane x = f where eyeGrid.x > f * eyeGrid.w, and likewise for y and z.
  glm::dvec4 eyeGrid;

  /// The ray of one pixel centre, x and y in [-1, 1].
  Ray At(double x, double y) const;

  /// The part of a ray from its start on that lies between the near and the far plane.
  Interval BetweenPlanes(const Ray& rayGrid) const;
};

/// @param clipFromGrid  grid space to OpenGL clip space, invertible
/// @param boxGrid       the volume
/// @throws std::invalid_argument when the matrix has no inverse
PixelRays ComputePixelRays(const glm::dmat4& clipFromGrid, const Box& boxGrid);

}

#endif
