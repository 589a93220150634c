#ifndef Varimarch_Core_Quality_TrialRays_h
#define Varimarch_Core_Quality_TrialRays_h

#include <glm/vec2.hpp>

#include <cstddef>
#include <vector>

namespace varimarch
{

/// The pixel of an image whose ray a trial image has: see Shaders/Math/TrialPixel.glsl, by which
/// both marchers find it.
/// @param rays  columns and rows of the trial image, at most as many as there are pixels
glm::ivec2 TrialPixelOf(const glm::ivec2& ray, const glm::ivec2& rays, const glm::ivec2& pixels);

/// The same for a list: some of its indices, ascending, one from each of equal parts.
/// @param most  the largest number of indices; a list of at most as many is taken whole
std::vector<std::size_t> TrialIndices(std::size_t count, std::size_t most);

}

#endif
