#include "Scene/SegmentTables.h"

#include "Scene/LookFormats/ColorTables.h"
#include "Scene/SmallFile.h"

#include <algorithm>

namespace varimarch
{

std::vector<Segment> ReadSegmentTable(const std::string& path)
{
  return SegmentsFromTable(BytesOfSmallFile(path), path);
}

void TakeTable(const std::vector<Segment>& table, std::vector<Segment>& segments)
{
  for (Segment& segment : segments)
  {
    const auto row = std::find_if(table.begin(), table.end(),
      [&](const Segment& candidate) { return candidate.value == segment.value; });
    segment = row != table.end() ? *row : segment;
  }
}

}
