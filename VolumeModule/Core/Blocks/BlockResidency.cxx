#include "Core/Blocks/BlockResidency.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace varimarch
{

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
