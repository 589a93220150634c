#include "March/Processor/PixelPlaces.h"

#include "Frame/VolumeGeometry.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

#include <cstddef>

namespace varimarch
{

PixelPlaces::PixelPlaces(vtkRenderer* renderer, const SceneDepthTexture& depth,
  const Viewport& viewport, const glm::dvec3& originWorld)
  : depths(depth.Texture().Texels<float>())
  , depthPixels(depth.SizePixels())
  , viewport(viewport)
  , placeFromClip(glm::inverse(glm::translate(ClipFromWorld(renderer), originWorld)))
{
}

double PixelPlaces::DepthAt(const glm::ivec2& pixel) const
{
  const glm::dvec2 part =
    (glm::dvec2(pixel) + 0.5) / glm::dvec2(this->viewport.width, this->viewport.height);
  const glm::ivec2 texel =
    glm::min(glm::ivec2(part * glm::dvec2(this->depthPixels)), this->depthPixels - 1);
  return this
    ->depths[std::size_t(texel.y) * std::size_t(this->depthPixels.x) + std::size_t(texel.x)];
}

glm::dvec3 PixelPlaces::PlaceAt(const glm::dvec2& pixel, double depth) const
{
  const glm::dvec4 clip(2.0 * (pixel.x + 0.5) / this->viewport.width - 1.0,
    2.0 * (pixel.y + 0.5) / this->viewport.height - 1.0, 2.0 * depth - 1.0, 1.0);
  const glm::dvec4 place = this->placeFromClip * clip;
  return glm::dvec3(place) / place.w;
}

double PixelPlaces::PixelMm(const glm::ivec2& pixel, double depth) const
{
  return glm::distance(this->PlaceAt(glm::dvec2(pixel) + glm::dvec2(1.0, 0.0), depth),
    this->PlaceAt(glm::dvec2(pixel), depth));
}

double PixelPlaces::UncertaintyMm(const glm::ivec2& pixel, double depth) const
{
  constexpr double DepthStep = 1.0 / (1 << 22);
  constexpr double MostSlope = 16.0;
  const glm::dvec2 center(pixel);
  return glm::distance(this->PlaceAt(center, depth - DepthStep), this->PlaceAt(center, depth)) +
    MostSlope * this->PixelMm(pixel, depth);
}

}
