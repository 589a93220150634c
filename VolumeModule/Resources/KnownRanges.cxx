#include "Resources/KnownRanges.h"

#include <algorithm>

namespace varimarch
{

std::shared_ptr<const BrickRanges> KnownRanges::Find(const Fingerprint& key)
{
  const auto found = std::find_if(this->entries.begin(), this->entries.end(),
    [&](const Entry& entry) { return entry.key == key; });
  if (found == this->entries.end())
  {
    return nullptr;
  }
  this->entries.splice(this->entries.begin(), this->entries, found);
  return this->entries.front().ranges;
}

void KnownRanges::Add(
  const Fingerprint& key, const std::shared_ptr<const BrickRanges>& ranges, std::size_t hostBytes)
{
  constexpr std::size_t PartOfHost = 32;
  const std::size_t mostBytes =
    hostBytes > 0 ? std::min(MostBytes, hostBytes / PartOfHost) : MostBytes;
  this->entries.push_front({ key, ranges });
  std::size_t bytes = 0;
  const auto tooMany = std::find_if(this->entries.begin(), this->entries.end(),
    [&](const Entry& entry)
    {
      bytes += entry.ranges->Bytes();
      return bytes > mostBytes;
    });
  this->entries.erase(tooMany, this->entries.end());
}

}
