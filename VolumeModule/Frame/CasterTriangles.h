#ifndef Varimarch_Frame_CasterTriangles_h
#define Varimarch_Frame_CasterTriangles_h

#include "Frame/ShadowCasters.h"

#include "vtkType.h"

#include <array>
#include <cstddef>
#include <vector>

namespace varimarch
{

/// The place of a triangle in the data.
struct SurfaceTriangle
{
  std::size_t surface;             ///< Its index in ShadowCasters::surfaces.
  std::array<vtkIdType, 3> points; ///< A triangle of the data that contains it.
};

/// The triangles of a surface, without the parts that planes take.
struct CasterTriangles
{
  std::vector<Triangle> corners;        ///< Relative to the origin of the casters [mm].
  std::vector<SurfaceTriangle> sources; ///< One for each triangle.
};

/// @param surface  its index in ShadowCasters::surfaces
CasterTriangles TrianglesOf(const ShadowCasters& casters, std::size_t surface);

}

#endif
