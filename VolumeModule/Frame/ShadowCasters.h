#ifndef Varimarch_Frame_ShadowCasters_h
#define Varimarch_Frame_ShadowCasters_h

#include "Core/Geometry/TriangleTree.h"
#include "Frame/Fingerprint.h"

#include "vtkType.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstddef>
#include <vector>

class vtkPolyData;
class vtkProperty;
class vtkRenderer;
class vtkVariationFieldVolumeMapper;
class vtkVolume;

namespace varimarch
{

/// A surface of opaque geometry. The data belong to the caller's pipeline.
struct CastingSurface
{
  vtkPolyData* data;
  vtkMTimeType time; ///< The time of the last change of the data.
  vtkProperty* property;
  bool hasColors; ///< True if colours of the data or of a block replace those of the property.
  glm::dmat4 worldFromData;
  std::vector<glm::dvec4> planesWorld; ///< They keep what lies on their positive sides.
};

/// The volumes whose shadows the geometry of a renderer receives.
enum class Shadowing
{
  Nothing, ///< Unknown colours may lie over those of geometry before a volume is drawn.
  OneVolume,
  AllVolumes ///< All volumes of the renderer, before the first of them is drawn.
};

/// The opaque geometry of a renderer that casts shadows on a volume: the surfaces of its visible
/// actors, also those in assemblies.
struct ShadowCasters
{
  std::vector<CastingSurface> surfaces;
  glm::dvec3 originWorld = glm::dvec3(0.0); ///< A place near the volume, for triangles of floats.
  Fingerprint fingerprint;                  ///< Everything that the triangles depend on.
  std::size_t triangleCount = 0;            ///< At most as many, with the cuts by planes.
  bool areTooMany = false; ///< True if there are too many triangles: then there are no surfaces.
  Shadowing shadowing = Shadowing::Nothing; ///< Volumes that also cast shadows on the surfaces.
  bool lieBehindTranslucent = false; ///< True if VTK has blended translucent geometry over them.
};

ShadowCasters ShadowCastersOf(
  vtkVariationFieldVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume);

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

/// Keeps a renderer from culling volumes out of the view whose shadows may fall on opaque geometry,
/// from the next image on: VTK does not draw a prop that is culled, nor does it tell anybody. Adds
/// a vtkCuller to the renderer, unless it has no culler or this one already.
void KeepShadowsOutOfView(vtkRenderer* renderer);

}

#endif
