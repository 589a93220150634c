#include "Core/Blocks/BlockResidency.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace varimarch
{

void BlockResidency::BeginPicture(const std::vector<int>& order)
{
  this->places.clear();
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    this->places[order[i]] = i;
  }
  this->place = 0;
}

std::size_t BlockResidency::NextUse(int block) const
{
  const auto found = this->places.find(block);
  const std::size_t pictureLength = this->places.size();
  if (found == this->places.end())
  {
    return 2 * pictureLength + (this->time - this->held.at(block).lastUse);
  }
  return found->second >= this->place ? found->second : found->second + pictureLength;
}

std::vector<int> BlockResidency::Shrink(std::size_t capacity)
{
  std::vector<int> letGo;
  while (this->Bytes() > capacity)
  {
    const auto farthest = std::max_element(this->held.begin(), this->held.end(),
      [&](const auto& a, const auto& b)
      { return this->NextUse(a.first) < this->NextUse(b.first); });
    letGo.push_back(farthest->first);
    this->held.erase(farthest);
  }
  return letGo;
}

std::vector<int> BlockResidency::Use(int block, std::size_t bytes, std::size_t capacity)
{
  if (bytes > capacity)
  {
    throw std::runtime_error("A block of " + std::to_string(bytes) +
      " bytes does not fit into the " + std::to_string(capacity) + " bytes left for blocks");
  }
  this->held.erase(block);
  const std::vector<int> letGo = this->Shrink(capacity - bytes);
  this->held[block] = { bytes, this->time };
  ++this->time;
  ++this->place;
  return letGo;
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
  this->places.clear();
}

}
