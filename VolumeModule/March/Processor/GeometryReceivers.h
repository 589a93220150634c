#ifndef Varimarch_March_Processor_GeometryReceivers_h
#define Varimarch_March_Processor_GeometryReceivers_h

#include "Core/Geometry/Viewport.h"
#include "Frame/Frame.h"
#include "Resources/SceneDepthTexture.h"
#include "Resources/SceneResources.h"

#include <glm/common.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

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

/// The places that pixels of a renderer show, by the depths of a framebuffer that were read into
/// memory.
class PixelPlaces
{
public:
  /// @param originWorld  the place that others are relative to
  PixelPlaces(const FrameView& view, const SceneDepthTexture& depth, const Viewport& viewport,
    const glm::dvec3& originWorld);

  /// The depth that a pixel shows, 1 where nothing was drawn.
  double DepthAt(const glm::ivec2& pixel) const;

  /// The place at a depth, in the world and relative to the origin.
  glm::dvec3 PlaceAt(const glm::dvec2& pixel, double depth) const;

  /// The distance of neighbouring pixels at a depth [mm].
  double PixelMm(const glm::ivec2& pixel, double depth) const;

  /// How far a depth may be from the surface along the ray: by the bits of the depth buffer, and by
  /// the slope of the surface within a pixel, whose depth may be that of a place off its centre.
  double UncertaintyMm(const glm::ivec2& pixel, double depth) const;

private:
  const float* depths;
  glm::ivec2 depthPixels;
  Viewport viewport;
  glm::dmat4 placeFromClip;
};

/// The factors of all pixels of a viewport from those of squares of pixels: each pixel takes the
/// mean of the four squares around it, by their distances in the image and by how near it is to the
/// plane of their geometry. Factors are 1 where none of the four shows geometry near that of the
/// pixel: small things between the middle pixels of squares keep all their light.
/// @param places       of the viewport's pixels, relative to originWorld
/// @param factors      of the squares
std::vector<glm::vec4> FactorsBetween(const ReceiverGrid& grid,
  const std::vector<GeometryReceiver>& receivers, const std::vector<glm::vec4>& factors,
  const PixelPlaces& places, const glm::dvec3& originWorld);

}

#endif
