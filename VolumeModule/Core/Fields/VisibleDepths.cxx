#include "Core/Fields/VisibleDepths.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <optional>

namespace varimarch
{

namespace
{

constexpr float Infinity = std::numeric_limits<float>::infinity();

// Number of blocks below which starting another thread would take longer than drawing them.
constexpr std::size_t BlocksAtATime = 512;
// Largest number of threads. Each needs a layer with an entry per packet, and all layers are
// joined.
constexpr std::size_t MostLayers = 8;

// The packets in which a block may be visible, and its range of depths.
struct Rectangle
{
  int left;
  int right; ///< included, as is top
  int bottom;
  int top;
  float nearest;
  float farthest;
};

// Half of the range that a function linear in grid space has over a block.
float ReachOf(const glm::vec3& perVoxel, float sideGrid)
{
  const glm::vec3 steps = glm::abs(perVoxel);
  return 0.5f * sideGrid * (steps.x + steps.y + steps.z);
}

glm::vec3 Row(const glm::mat4& matrix, int row)
{
  return { matrix[0][row], matrix[1][row], matrix[2][row] };
}

// The projection of blocks of one size onto packets.
class Projection
{
public:
  Projection(const glm::dmat4& clipFromGrid, const glm::vec3& axisGrid, float sideGrid,
    const glm::vec2& picturePixels, const glm::ivec2& firstPacket, const glm::ivec2& packetCount)
    : matrix(clipFromGrid)
    , axisGrid(axisGrid)
    , reach(ReachOf(Row(matrix, 0), sideGrid), ReachOf(Row(matrix, 1), sideGrid))
    , weightReach(ReachOf(Row(matrix, 3), sideGrid))
    , depthReach(ReachOf(axisGrid, sideGrid))
    , halfPicture(0.5f * picturePixels)
    , firstPixel(glm::vec2(firstPacket) * Packet)
    , count(packetCount)
  {
  }

  // Returns nothing if the block may touch the plane of the eye.
  std::optional<Rectangle> RectangleOf(const glm::vec3& centerGrid) const
  {
    const glm::vec4 clip = this->matrix * glm::vec4(centerGrid, 1.0f);
    if (!(clip.w > 1.01f * this->weightReach))
    {
      return std::nullopt;
    }
    const float nearScale = 1.0f / (clip.w - this->weightReach);
    const float farScale = 1.0f / (clip.w + this->weightReach);
    const glm::vec2 lower = glm::vec2(clip) - this->reach;
    const glm::vec2 upper = glm::vec2(clip) + this->reach;
    // One pixel is added on each side for rays away from the pixels' centres.
    const glm::vec2 from =
      (glm::min(lower * nearScale, lower * farScale) + 1.0f) * this->halfPicture -
      this->firstPixel - 1.0f;
    const glm::vec2 to =
      (glm::max(upper * nearScale, upper * farScale) + 1.0f) * this->halfPicture -
      this->firstPixel + 1.0f;
    // Clamped before the conversion, because integers cannot hold positions close to the eye.
    const glm::ivec2 begin(glm::clamp(glm::floor(from / Packet), glm::vec2(0.0f), this->count));
    const glm::ivec2 last(
      glm::clamp(glm::floor(to / Packet), glm::vec2(-1.0f), this->count - 1.0f));
    const float depth = glm::dot(this->axisGrid, centerGrid);
    return Rectangle{ begin.x, last.x, begin.y, last.y, depth - this->depthReach,
      depth + this->depthReach };
  }

private:
  static constexpr glm::vec2 Packet = glm::vec2(PacketWidth, PacketHeight);

  glm::mat4 matrix;
  glm::vec3 axisGrid;
  glm::vec2 reach; ///< half extent of a block in clip space
  float weightReach;
  float depthReach;
  glm::vec2 halfPicture; ///< [pixels]
  glm::vec2 firstPixel;
  glm::vec2 count; ///< number of packets
};

void Begin(VisibleLayer& layer, int columns, int rows)
{
  const std::size_t count = std::size_t(columns) * rows;
  layer.columns = columns;
  layer.nearest.assign(count, Infinity);
  layer.farthest.assign(count, -Infinity);
  layer.isBounded = true;
}

void DrawBlock(VisibleLayer& layer, const Rectangle& block)
{
  for (int row = block.bottom; row <= block.top; ++row)
  {
    float* const nearestOf = &layer.nearest[std::size_t(row) * layer.columns];
    float* const farthestOf = &layer.farthest[std::size_t(row) * layer.columns];
    for (int column = block.left; column <= block.right; ++column)
    {
      nearestOf[column] = std::min(nearestOf[column], block.nearest);
      farthestOf[column] = std::max(farthestOf[column], block.farthest);
    }
  }
}

// Draws blocks that no other layer has taken, until none is left.
void DrawNext(VisibleLayer& layer, const Projection& projection, const VisibleBlocks& blocks,
  std::atomic<std::size_t>& next)
{
  const std::size_t count = blocks.centersGrid.size();
  for (std::size_t first = next.fetch_add(BlocksAtATime); first < count && layer.isBounded;
       first = next.fetch_add(BlocksAtATime))
  {
    const std::size_t end = std::min(first + BlocksAtATime, count);
    for (std::size_t i = first; i < end && layer.isBounded; ++i)
    {
      const std::optional<Rectangle> block = projection.RectangleOf(blocks.centersGrid[i]);
      layer.isBounded = block.has_value();
      if (block)
      {
        DrawBlock(layer, *block);
      }
    }
  }
}

void Join(VisibleLayer& all, const VisibleLayer& layer)
{
  all.isBounded = all.isBounded && layer.isBounded;
  std::transform(all.nearest.begin(), all.nearest.end(), layer.nearest.begin(), all.nearest.begin(),
    [](float a, float b) { return std::min(a, b); });
  std::transform(all.farthest.begin(), all.farthest.end(), layer.farthest.begin(),
    all.farthest.begin(), [](float a, float b) { return std::max(a, b); });
}

}

PacketDepths VisibleDepths::Draw(const VisibleBlocks& blocks, const glm::dmat4& clipFromGrid,
  const glm::vec3& directionGrid, glm::ivec2 picturePixels, const Viewport& pixels)
{
  const glm::vec3 axisGrid = glm::normalize(directionGrid);
  const glm::ivec2 first(pixels.left / PacketWidth, pixels.bottom / PacketHeight);
  const glm::ivec2 count = glm::ivec2((pixels.left + pixels.width - 1) / PacketWidth,
                             (pixels.bottom + pixels.height - 1) / PacketHeight) +
    1 - first;
  const Projection projection(clipFromGrid, axisGrid, blocks.sideGrid, picturePixels, first, count);

  const std::size_t threads = std::size_t(tbb::this_task_arena::max_concurrency());
  this->layers.resize(std::clamp<std::size_t>(
    blocks.centersGrid.size() / BlocksAtATime, 1, std::min(threads, MostLayers)));
  std::atomic<std::size_t> next = 0;
  tbb::parallel_for(std::size_t(0), this->layers.size(),
    [&](std::size_t i)
    {
      Begin(this->layers[i], count.x, count.y);
      DrawNext(this->layers[i], projection, blocks, next);
    });
  VisibleLayer& all = this->layers.front();
  for (std::size_t i = 1; i < this->layers.size(); ++i)
  {
    Join(all, this->layers[i]);
  }
  if (!all.isBounded)
  {
    return {};
  }
  return { axisGrid, all.nearest.data(), all.farthest.data(), count.x, first.x * PacketWidth,
    first.y * PacketHeight };
}

}
