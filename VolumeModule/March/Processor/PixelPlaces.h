#ifndef Varimarch_March_Processor_PixelPlaces_h
#define Varimarch_March_Processor_PixelPlaces_h

#include "Core/Geometry/Viewport.h"
#include "Resources/SceneDepthTexture.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

class vtkRenderer;

namespace varimarch
{

/// The places that pixels of a renderer show, by the depths of a framebuffer that were read into
/// memory.
class PixelPlaces
{
public:
  /// @param originWorld  the place that others are relative to
  PixelPlaces(vtkRenderer* renderer, const SceneDepthTexture& depth, const Viewport& viewport,
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

}

#endif
