#include "Core/Blocks/BlockPartition.h"

#include "Core/Fields/BrickRanges.h"

#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <stdexcept>
#include <string>

namespace varimarch
{
namespace
{

// Blocks consist of whole bricks, so that what a field knows about bricks also holds for blocks.
constexpr int Brick = BrickRanges::CellsPerSide;

// A row of cells has one voxel more than it has cells, and gradients read one voxel beyond each
// end.
constexpr int SharedVoxels = 3;

}

BlockPartition::BlockPartition(glm::ivec3 dimensions, const BlockLimits& limits)
  : dimensions(dimensions)
  , cellCount(glm::max(dimensions - 1, glm::ivec3(1)))
  , cellsPerBlock(cellCount)
  , count(1)
{
  while (!this->Fits(limits))
  {
    const glm::ivec3 cells = this->cellsPerBlock;
    const int longest = cells.x >= cells.y && cells.x >= cells.z ? 0 : (cells.y >= cells.z ? 1 : 2);
    if (cells[longest] <= Brick)
    {
      throw std::runtime_error("Cannot divide the volume into blocks of at most " +
        std::to_string(limits.largestBytes) + " bytes: the smallest possible block needs " +
        std::to_string(SmallestBytes(limits.bytesPerVoxel)) + " bytes");
    }
    this->CutAlong(longest);
  }
}

std::size_t BlockPartition::SmallestBytes(std::size_t bytesPerVoxel)
{
  constexpr std::size_t side = Brick + SharedVoxels;
  return bytesPerVoxel * side * side * side;
}

bool BlockPartition::Fits(const BlockLimits& limits) const
{
  const glm::ivec3 voxels = glm::min(this->cellsPerBlock + SharedVoxels, this->dimensions);
  const std::size_t bytes = limits.bytesPerVoxel * voxels.x * voxels.y * voxels.z;
  return std::max({ voxels.x, voxels.y, voxels.z }) <= limits.largestSide &&
    bytes <= limits.largestBytes;
}

void BlockPartition::CutAlong(int axis)
{
  const auto quotient = [](int dividend, int divisor)
  { return (dividend + divisor - 1) / divisor; };
  const int cells = this->cellCount[axis];
  const int shorter = (quotient(this->cellsPerBlock[axis], Brick) - 1) * Brick;
  const int parts = quotient(cells, shorter);
  this->cellsPerBlock[axis] = quotient(quotient(cells, parts), Brick) * Brick;
  this->count[axis] = quotient(cells, this->cellsPerBlock[axis]);
}

glm::ivec3 BlockPartition::IndexOf(int block) const
{
  return { block % this->count.x, block / this->count.x % this->count.y,
    block / (this->count.x * this->count.y) };
}

VoxelRegion BlockPartition::VoxelsOf(int block) const
{
  const glm::ivec3 firstCell = this->IndexOf(block) * this->cellsPerBlock;
  const glm::ivec3 behindCells = glm::min(firstCell + this->cellsPerBlock, this->cellCount);
  const glm::ivec3 first = glm::max(firstCell - 1, glm::ivec3(0));
  const glm::ivec3 last = glm::min(behindCells + 1, this->dimensions - 1);
  return { first, last - first + 1 };
}

Box BlockPartition::BoxOf(int block, const Box& boxGrid) const
{
  const glm::ivec3 index = this->IndexOf(block);
  const glm::dvec3 lower(index * this->cellsPerBlock);
  const glm::dvec3 upper((index + 1) * this->cellsPerBlock);
  Box box = boxGrid;
  for (int axis = 0; axis < 3; ++axis)
  {
    if (index[axis] > 0)
    {
      box.lower[axis] = lower[axis];
    }
    if (index[axis] < this->count[axis] - 1)
    {
      box.upper[axis] = upper[axis];
    }
  }
  return box;
}

std::vector<int> BlockPartition::FrontToBack(const glm::dvec4& eyeGrid) const
{
  glm::ivec3 eyeBlock(0);
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto eyeIsBeyond = [&](double face) { return eyeGrid[axis] > face * eyeGrid.w; };
    while (eyeBlock[axis] < this->count[axis] - 1 &&
      eyeIsBeyond((eyeBlock[axis] + 1.0) * this->cellsPerBlock[axis]))
    {
      ++eyeBlock[axis];
    }
  }
  const auto distance = [&](int block)
  {
    const glm::ivec3 away = glm::abs(this->IndexOf(block) - eyeBlock);
    return away.x + away.y + away.z;
  };
  std::vector<int> order(this->Count());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(
    order.begin(), order.end(), [&](int a, int b) { return distance(a) < distance(b); });
  return order;
}

void BlockResidency::BeginPicture(const std::vector<int>& order)
{
  this->positions.clear();
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    this->positions[order[i]] = i;
  }
  this->position = 0;
}

std::size_t BlockResidency::NextUse(int block) const
{
  const auto found = this->positions.find(block);
  const std::size_t pictureLength = this->positions.size();
  if (found == this->positions.end())
  {
    return 2 * pictureLength + (this->time - this->held.at(block).lastUse);
  }
  return found->second >= this->position ? found->second : found->second + pictureLength;
}

std::vector<int> BlockResidency::Shrink(std::size_t capacity)
{
  std::vector<int> evicted;
  while (this->Bytes() > capacity)
  {
    const auto farthest = std::max_element(this->held.begin(), this->held.end(),
      [&](const auto& a, const auto& b)
      { return this->NextUse(a.first) < this->NextUse(b.first); });
    evicted.push_back(farthest->first);
    this->held.erase(farthest);
  }
  return evicted;
}

std::vector<int> BlockResidency::Use(int block, std::size_t bytes, std::size_t capacity)
{
  if (bytes > capacity)
  {
    throw std::runtime_error("A block needs " + std::to_string(bytes) + " bytes, but only " +
      std::to_string(capacity) + " bytes are left for blocks");
  }
  this->held.erase(block);
  const std::vector<int> evicted = this->Shrink(capacity - bytes);
  this->held[block] = { bytes, this->time };
  ++this->time;
  ++this->position;
  return evicted;
}

std::size_t BlockResidency::Bytes() const
{
  std::size_t bytes = 0;
  for (const auto& [block, entry] : this->held)
  {
    bytes += entry.bytes;
  }
  return bytes;
}

void BlockResidency::Clear()
{
  this->held.clear();
  this->positions.clear();
}

}
