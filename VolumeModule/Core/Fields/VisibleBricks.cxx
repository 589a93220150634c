#include "Core/Fields/VisibleBricks.h"

#include <glm/common.hpp>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstdint>
#include <iterator>

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

}
