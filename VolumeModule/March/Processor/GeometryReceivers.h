#ifndef Varimarch_March_Processor_GeometryReceivers_h
#define Varimarch_March_Processor_GeometryReceivers_h

#include "Core/Geometry/Viewport.h"
#include "Frame/Frame.h"
#include "Resources/SceneResources.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <vector>

namespace varimarch
{

/// A place of opaque geometry that a pixel shows.
struct GeometryReceiver
{
  std::size_t pixel;   ///< Its number in the viewport, row by row from below.
  std::size_t surface; ///< Its index in ShadowCasters::surfaces.
  glm::dvec3 placeWorld;
  glm::dvec3 normalWorld; ///< unit vector, on the side of the eye
  glm::dvec3 toEyeWorld;  ///< unit vector to the camera, in parallel projection too, as in VTK
};

/// The places of the geometry in Frame::casters that are seen, by the depths of the framebuffer and
/// the triangles of the geometry. Pixels that show anything else, such as lines, have none.
/// @param viewport   that of the depths
std::vector<GeometryReceiver> GeometryReceiversOf(
  const Frame& frame, SceneResources& resources, const Viewport& viewport);

}

#endif
