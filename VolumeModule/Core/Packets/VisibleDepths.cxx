#include "Core/Packets/VisibleDepths.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>

namespace varimarch
{

/// The packets that a block may be seen in, and its depths.
struct VisibleDepths::Block
{
  int left;
  int right; ///< included, as top
  int bottom;
  int top;
  float nearest;
  float farthest;
};

namespace
{

constexpr float Infinity = std::numeric_limits<float>::infinity();

// Half of what a block covers along a function that is linear in the grid.
float ReachOf(const glm::vec3& perVoxel, float sideGrid)
{
  const glm::vec3 steps = glm::abs(perVoxel);
  return 0.5f * sideGrid * (steps.x + steps.y + steps.z);
}

glm::vec3 Row(const glm::mat4& matrix, int row)
{
  return { matrix[0][row], matrix[1][row], matrix[2][row] };
}

}

VisibleDepths::VisibleDepths(const VisibleBlocks& blocks, const glm::dmat4& clipFromGrid,
  const PacketCamera& camera, const Viewport& pixels)
  : axisGrid(glm::normalize(camera.directionGrid[0]))
  , firstColumn(pixels.left / PacketWidth)
  , firstRow(pixels.bottom / PacketHeight)
  , columns((pixels.left + pixels.width - 1) / PacketWidth + 1 - firstColumn)
  , rows((pixels.bottom + pixels.height - 1) / PacketHeight + 1 - firstRow)
  , nearest(std::size_t(columns) * rows, Infinity)
  , farthest(std::size_t(columns) * rows, -Infinity)
{
  const glm::mat4 matrix(clipFromGrid);
  const glm::vec3 reach(ReachOf(Row(matrix, 0), blocks.sideGrid),
    ReachOf(Row(matrix, 1), blocks.sideGrid), ReachOf(Row(matrix, 3), blocks.sideGrid));
  const float depthReach = ReachOf(this->axisGrid, blocks.sideGrid);
  const glm::vec2 halfPicture = 0.5f * glm::vec2(camera.pictureWidth, camera.pictureHeight);
  const glm::vec2 first(
    float(this->firstColumn * PacketWidth), float(this->firstRow * PacketHeight));
  const glm::vec2 packet = { PacketWidth, PacketHeight };
  const glm::vec2 count(float(this->columns), float(this->rows));
  for (const glm::vec3& center : blocks.centersGrid)
  {
    const glm::vec4 clip = matrix * glm::vec4(center, 1.0f);
    if (!(clip.w > 1.01f * reach.z))
    {
      this->isBounded = false;
      return;
    }
    const float nearScale = 1.0f / (clip.w - reach.z);
    const float farScale = 1.0f / (clip.w + reach.z);
    const glm::vec2 lower = glm::vec2(clip) - glm::vec2(reach);
    const glm::vec2 upper = glm::vec2(clip) + glm::vec2(reach);
    // In pixels, with one more to every side for rays beside the middles of theirs.
    const glm::vec2 from =
      (glm::min(lower * nearScale, lower * farScale) + 1.0f) * halfPicture - first - 1.0f;
    const glm::vec2 to =
      (glm::max(upper * nearScale, upper * farScale) + 1.0f) * halfPicture - first + 1.0f;
    // Clamped before they are integers, which cannot hold what is close to the eye.
    const glm::ivec2 begin(glm::clamp(glm::floor(from / packet), glm::vec2(0.0f), count));
    const glm::ivec2 last(glm::clamp(glm::floor(to / packet), glm::vec2(-1.0f), count - 1.0f));
    const float depth = glm::dot(this->axisGrid, center);
    this->Draw({ begin.x, last.x, begin.y, last.y, depth - depthReach, depth + depthReach });
  }
}

void VisibleDepths::Draw(const Block& block)
{
  for (int row = block.bottom; row <= block.top; ++row)
  {
    float* const nearestOf = &this->nearest[std::size_t(row) * this->columns];
    float* const farthestOf = &this->farthest[std::size_t(row) * this->columns];
    for (int column = block.left; column <= block.right; ++column)
    {
      nearestOf[column] = std::min(nearestOf[column], block.nearest);
      farthestOf[column] = std::max(farthestOf[column], block.farthest);
    }
  }
}

PacketDepths VisibleDepths::Depths() const
{
  if (!this->isBounded)
  {
    return {};
  }
  return { this->axisGrid, this->nearest.data(), this->farthest.data(), this->columns,
    this->firstColumn * PacketWidth, this->firstRow * PacketHeight };
}

}
