#include "Core/Blocks/BoxOrder.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

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

// True unless a plane between two boxes has the eye in it or on the side of `b`: from there no ray
// meets `a` first.
bool MayHide(const Box& a, const Box& b, const glm::dvec4& eye)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if ((IsBelow(a, b, axis) && eye[axis] >= a.upper[axis] * eye.w) ||
      (IsBelow(b, a, axis) && eye[axis] <= a.lower[axis] * eye.w))
    {
      return false;
    }
  }
  return true;
}

// A number that grows with the distance of a box's centre from the eye.
double Distance(const Box& box, const glm::dvec4& eye)
{
  const glm::dvec3 centre = 0.5 * (box.lower + box.upper);
  const glm::dvec3 position(eye);
  return eye.w == 0.0 ? -glm::dot(centre, position) : glm::distance(centre, position / eye.w);
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

std::vector<int> FrontToBack(const std::vector<Box>& boxes, const glm::dvec4& eye)
{
  const int count = static_cast<int>(boxes.size());
  std::vector<int> hiders(count, 0); // the number of boxes in front of each that are still to come
  for (int box = 0; box < count; ++box)
  {
    hiders[box] = static_cast<int>(std::count_if(boxes.begin(), boxes.end(),
      [&](const Box& other) { return &other != &boxes[box] && MayHide(other, boxes[box], eye); }));
  }
  std::vector<int> rest(count);
  std::generate(rest.begin(), rest.end(), [next = 0]() mutable { return next++; });
  std::stable_sort(rest.begin(), rest.end(),
    [&](int a, int b) { return Distance(boxes[a], eye) < Distance(boxes[b], eye); });
  std::vector<int> order;
  while (!rest.empty())
  {
    auto next = std::find_if(rest.begin(), rest.end(), [&](int box) { return hiders[box] == 0; });
    next = next == rest.end() ? rest.begin() : next;
    const int first = *next;
    rest.erase(next);
    order.push_back(first);
    for (int box : rest)
    {
      hiders[box] -= MayHide(boxes[first], boxes[box], eye) ? 1 : 0;
    }
  }
  return order;
}

}
