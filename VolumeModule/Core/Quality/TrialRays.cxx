#include "Core/Quality/TrialRays.h"

#include <glm/glm.hpp>

#include <algorithm>

namespace varimarch
{

namespace
{

using glm::ivec2;
using glm::uvec2;
#include "Shaders/Math/TrialPixel.glsl"

}

glm::ivec2 TrialPixelOf(const glm::ivec2& ray, const glm::ivec2& rays, const glm::ivec2& pixels)
{
  return TrialPixel(ray, rays, pixels);
}

std::vector<std::size_t> TrialIndices(std::size_t count, std::size_t most)
{
  std::vector<std::size_t> indices(std::min(count, most));
  for (std::size_t i = 0; i < indices.size(); ++i)
  {
    const std::size_t first = i * count / indices.size();
    const std::size_t behind = (i + 1) * count / indices.size();
    indices[i] = first + HashOf({ int(i), 0 }).x % (behind - first);
  }
  return indices;
}

}
