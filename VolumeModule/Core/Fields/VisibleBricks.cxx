#include "Core/Fields/VisibleBricks.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <iterator>
#include <limits>
#include <optional>

namespace varimarch
{
namespace
{

// A flag for each block of bricks that contains something visible, with a border of empty blocks.
class VisibleBlocksOfBricks
{
public:
  VisibleBlocksOfBricks(const OpticalField& field, int side)
    : count((field.brickCount + side - 1) / side)
    , holds(std::size_t(count.x + 2) * (count.y + 2) * (count.z + 2), 0)
  {
    tbb::parallel_for(0, this->count.z,
      [&](int blockZ)
      {
        for (int z = side * blockZ; z < std::min(side * (blockZ + 1), field.brickCount.z); ++z)
        {
          for (int y = 0; y < field.brickCount.y; ++y)
          {
            this->AddRow(field, side, y, z);
          }
        }
      });
  }

  bool At(int x, int y, int z) const { return this->holds[this->IndexOf(x, y, z)] != 0; }

  const glm::ivec3 count;

private:
  std::size_t IndexOf(int x, int y, int z) const
  {
    return (std::size_t(z + 1) * (this->count.y + 2) + (y + 1)) * (this->count.x + 2) + (x + 1);
  }

  void AddRow(const OpticalField& field, int side, int y, int z)
  {
    const int length = field.brickCount.x;
    const std::uint8_t* const row =
      &field.bricks[(std::size_t(z) * field.brickCount.y + y) * length];
    for (int x = 0, block = 0; x < length; x += side, ++block)
    {
      const bool isVisible = std::any_of(row + x, row + std::min(x + side, length),
        [](std::uint8_t brick) { return brick < OpticalField::Invisible; });
      this->holds[this->IndexOf(block, y / side, z / side)] |= std::uint8_t(isVisible);
    }
  }

  std::vector<std::uint8_t> holds;
};

}

std::vector<glm::ivec3> VisibleHull(const OpticalField& field, int side)
{
  const VisibleBlocksOfBricks visible(field, side);
  std::vector<glm::ivec3> hull;
  for (int z = 0; z < visible.count.z; ++z)
  {
    for (int y = 0; y < visible.count.y; ++y)
    {
      for (int x = 0; x < visible.count.x; ++x)
      {
        const bool isInside = visible.At(x - 1, y, z) && visible.At(x + 1, y, z) &&
          visible.At(x, y - 1, z) && visible.At(x, y + 1, z) && visible.At(x, y, z - 1) &&
          visible.At(x, y, z + 1);
        if (visible.At(x, y, z) && !isInside)
        {
          hull.emplace_back(x, y, z);
        }
      }
    }
  }
  return hull;
}

VisibleBricks::VisibleBricks(const OpticalField& field)
  : side(field.side)
  , brickCount(field.brickCount)
  , visible(field.bricks.size())
{
  for (std::size_t i = 0; i < field.bricks.size(); ++i)
  {
    this->visible[i] = field.bricks[i] < OpticalField::Invisible;
  }
}

Box VisibleBricks::Bounds(const Box& partGrid) const
{
  const glm::ivec3 count = this->brickCount;
  const glm::ivec3 lowest = glm::clamp(
    glm::ivec3(glm::floor(partGrid.lower / double(this->side))), glm::ivec3(0), count - 1);
  // A part beyond the outermost voxels shows the outermost bricks.
  const glm::ivec3 behind =
    glm::clamp(glm::ivec3(glm::ceil(partGrid.upper / double(this->side))), lowest + 1, count);
  glm::ivec3 first = count;
  glm::ivec3 last(-1);
  for (int z = lowest.z; z < behind.z; ++z)
  {
    for (int y = lowest.y; y < behind.y; ++y)
    {
      const auto row = this->visible.begin() + (std::ptrdiff_t(z) * count.y + y) * count.x;
      const auto found = std::find(row + lowest.x, row + behind.x, true);
      if (found != row + behind.x)
      {
        const auto afterLast = std::find(std::make_reverse_iterator(row + behind.x),
          std::make_reverse_iterator(row + lowest.x), true)
                                 .base();
        first = glm::min(first, glm::ivec3(int(found - row), y, z));
        last = glm::max(last, glm::ivec3(int(afterLast - row) - 1, y, z));
      }
    }
  }
  Box box;
  for (int axis = 0; axis < 3; ++axis)
  {
    box.lower[axis] =
      first[axis] == lowest[axis] ? partGrid.lower[axis] : double(this->side * first[axis]);
    box.upper[axis] =
      last[axis] == behind[axis] - 1 ? partGrid.upper[axis] : double(this->side * (last[axis] + 1));
  }
  return box;
}

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
