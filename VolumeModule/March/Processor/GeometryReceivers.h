#ifndef Varimarch_March_Processor_GeometryReceivers_h
#define Varimarch_March_Processor_GeometryReceivers_h

#include "Core/Geometry/Viewport.h"
#include "Frame/Frame.h"
#include "Resources/SceneResources.h"

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <vector>

namespace varimarch
{

/// The pixels whose geometry is asked for light: all, or the middle ones of squares of pixels.
struct ReceiverGrid
{
  Viewport viewport = {};
  int side = 1; ///< The side of a square [pixels].

  /// The squares, as pixels of a smaller image.
  Viewport Pixels() const
  {
    return { 0, 0, (this->viewport.width + this->side - 1) / this->side,
      (this->viewport.height + this->side - 1) / this->side };
  }
  /// The pixel in the middle of a square, counted from the corner of the viewport.
  glm::ivec2 PixelOf(const glm::ivec2& square) const
  {
    return glm::min(this->side * square + this->side / 2,
      glm::ivec2(this->viewport.width, this->viewport.height) - 1);
  }
};

/// A place of opaque geometry that a pixel shows.
struct GeometryReceiver
{
  std::size_t pixel;   ///< The number of its square, row by row from below.
  std::size_t surface; ///< Its index in ShadowCasters::surfaces.
  glm::dvec3 placeWorld;
  glm::dvec3 normalWorld; ///< unit vector, on the side of the eye
  glm::dvec3 toEyeWorld;  ///< unit vector to the camera, in parallel projection too, as in VTK
  double pixelMm;         ///< The distance to what a neighbouring pixel shows at the same depth.
};

/// The places of the geometry in Frame::casters that are seen, by the depths of the framebuffer and
/// the triangles of the geometry. Pixels that show anything else, such as lines, have none.
/// @param grid  the squares of the viewport of the depths
std::vector<GeometryReceiver> GeometryReceiversOf(
  const Frame& frame, SceneResources& resources, const ReceiverGrid& grid);

}

#endif
