#include "Core/Blocks/BoxOverlap.h"

#include <algorithm>

namespace varimarch
{

namespace
{

// True if box `a` ends on an axis where box `b` begins, or before.
bool IsBelow(const Box& a, const Box& b, int axis)
{
  const double side = std::min(a.upper[axis] - a.lower[axis], b.upper[axis] - b.lower[axis]);
  return a.upper[axis] - b.lower[axis] <= 1e-6 * side;
}

bool AreApart(const Box& a, const Box& b)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (IsBelow(a, b, axis) || IsBelow(b, a, axis))
    {
      return true;
    }
  }
  return false;
}

}

std::optional<std::pair<int, int>> FirstOverlap(const std::vector<Box>& boxes)
{
  const int count = static_cast<int>(boxes.size());
  for (int b = 1; b < count; ++b)
  {
    for (int a = 0; a < b; ++a)
    {
      if (!AreApart(boxes[a], boxes[b]))
      {
        return std::pair(a, b);
      }
    }
  }
  return std::nullopt;
}

}
