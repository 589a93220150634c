#include "Core/Look/OpaqueValues.h"

#include <cstddef>
#include <limits>

namespace varimarch
{

std::vector<ValueRange> OpaqueValues(
  const TransferFunction& transferFunction, const ValueRange& values)
{
  constexpr double Infinity = std::numeric_limits<double>::infinity();
  const std::vector<OpacityNode>& nodes = transferFunction.Opacities();
  std::vector<ValueRange> ranges;
  for (std::size_t first = 0; first < nodes.size(); ++first)
  {
    std::size_t behind = first;
    while (behind < nodes.size() && nodes[behind].opacity >= 1.0)
    {
      ++behind;
    }
    if (behind == first)
    {
      continue;
    }
    const ValueRange range{ first == 0 ? -Infinity : nodes[first].value,
      behind == nodes.size() ? Infinity : nodes[behind - 1].value };
    const bool beginsInside = values.lower < range.lower && range.lower <= values.upper;
    const bool endsInside = values.lower <= range.upper && range.upper < values.upper;
    if (range.lower < range.upper && (beginsInside || endsInside))
    {
      ranges.push_back(range);
    }
    first = behind;
  }
  return ranges;
}

}
