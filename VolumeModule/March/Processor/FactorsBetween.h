#ifndef Varimarch_March_Processor_FactorsBetween_h
#define Varimarch_March_Processor_FactorsBetween_h

#include "March/Processor/GeometryReceivers.h"
#include "March/Processor/PixelPlaces.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <vector>

namespace varimarch
{

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
