#include "Readers/SegmentOverlap.h"

#include <algorithm>

namespace varimarch
{
namespace
{

std::string NameOf(int value, const std::vector<LabelledSegment>& segments)
{
  const auto segment = std::find_if(segments.begin(), segments.end(),
    [&](const LabelledSegment& candidate) { return candidate.value == value; });
  const bool hasName = segment != segments.end() && !segment->name.empty();
  return hasName ? '"' + segment->name + '"' : "segment " + std::to_string(value);
}

}

void SegmentOverlap::Put(const std::vector<std::uint16_t>& numbers, std::uint16_t* voxels)
{
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    const auto [lower, upper] = std::minmax(numbers[i], voxels[i]);
    if (lower != 0 && lower != upper)
    {
      ++this->covered[{ lower, upper }];
    }
    voxels[i] = upper;
  }
}

void SegmentOverlap::Warn(
  const std::vector<LabelledSegment>& segments, std::vector<std::string>& warnings) const
{
  constexpr std::size_t MostNamed = 3;
  if (this->covered.empty())
  {
    return;
  }
  std::string list;
  std::size_t count = 0;
  for (const auto& [pair, voxels] : this->covered)
  {
    if (++count <= MostNamed)
    {
      list += (count > 1 ? ", " : "") + NameOf(pair.second, segments) + " over " +
        NameOf(pair.first, segments) + " (" + std::to_string(voxels) +
        (voxels == 1 ? " voxel)" : " voxels)");
    }
  }
  const std::string more =
    count > MostNamed ? " and " + std::to_string(count - MostNamed) + " more pairs" : "";
  warnings.push_back(
    "Segments overlap, and the later one is drawn over the other: " + list + more + ".");
}

}
