#include "Core/Blocks/OwnerOrder.h"

#include "Core/Geometry/ProjectedBox.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <numeric>

namespace varimarch
{
namespace
{

// The picture in whose pixels hidden parts are measured.
constexpr Viewport Picture{ 0, 0, 1024, 1024 };

struct Solid
{
  CornersClip corners; // in the world
  Viewport pixels;
  int owner;

  glm::dvec3 Edge(int axis) const
  {
    return glm::dvec3(this->corners[std::size_t(1) << axis] - this->corners[0]);
  }
};

Solid SolidOf(const OwnedBox& owned, const glm::dmat4& clipFromWorld)
{
  const glm::dmat4 clipFromData = clipFromWorld * owned.worldFromData;
  constexpr Viewport Nothing{ 0, 0, 0, 0 };
  return { CornersOf(owned.box, owned.worldFromData),
    IsInView(owned.box, clipFromData) ? PixelsOf(owned.box, clipFromData, Picture) : Nothing,
    owned.owner };
}

// The eye in homogeneous coordinates: the point at infinity in front of the picture's centre. It is
// the direction towards the eye, with a w of 0, for a parallel projection.
glm::dvec4 EyeOf(const glm::dmat4& clipFromWorld)
{
  return glm::inverse(clipFromWorld) * glm::dvec4(0.0, 0.0, -1.0, 0.0);
}

struct Reach
{
  double lower;
  double upper;
};

Reach ReachAlong(const glm::dvec3& direction, const Solid& solid)
{
  Reach reach{ glm::dot(direction, glm::dvec3(solid.corners[0])), 0.0 };
  reach.upper = reach.lower;
  for (const glm::dvec4& corner : solid.corners)
  {
    const double place = glm::dot(direction, glm::dvec3(corner));
    reach = { std::min(reach.lower, place), std::max(reach.upper, place) };
  }
  return reach;
}

// The normals of the planes that can separate two solids: those of their faces, and those along an
// edge of each (Gottschalk, Lin and Manocha, SIGGRAPH 1996).
std::vector<glm::dvec3> Normals(const Solid& a, const Solid& b)
{
  std::vector<glm::dvec3> normals;
  const auto add = [&](const glm::dvec3& first, const glm::dvec3& second)
  {
    const glm::dvec3 normal = glm::cross(first, second);
    const double length = glm::length(normal);
    // Parallel edges are in no plane of their own.
    if (length > 1e-9 * glm::length(first) * glm::length(second))
    {
      normals.push_back(normal / length);
    }
  };
  for (int i = 0; i < 3; ++i)
  {
    add(a.Edge(i), a.Edge((i + 1) % 3));
    add(b.Edge(i), b.Edge((i + 1) % 3));
    for (int j = 0; j < 3; ++j)
    {
      add(a.Edge(i), b.Edge(j));
    }
  }
  return normals;
}

struct Hiding
{
  bool firstHidesSecond = true;
  bool secondHidesFirst = true;
};

// A plane between two solids excludes that the one beyond it, seen from the eye, hides the other.
Hiding HidingOf(const Solid& a, const Solid& b, const glm::dvec4& eye)
{
  Hiding hiding;
  for (const glm::dvec3& normal : Normals(a, b))
  {
    const Reach reachA = ReachAlong(normal, a);
    const Reach reachB = ReachAlong(normal, b);
    const double place = glm::dot(normal, glm::dvec3(eye));
    // Solids that touch may overlap by rounding.
    const double rounding =
      1e-6 * std::min(reachA.upper - reachA.lower, reachB.upper - reachB.lower);
    if (reachA.upper - reachB.lower <= rounding)
    {
      hiding.firstHidesSecond = hiding.firstHidesSecond && place < reachA.upper * eye.w;
      hiding.secondHidesFirst = hiding.secondHidesFirst && place > reachB.lower * eye.w;
    }
    else if (reachB.upper - reachA.lower <= rounding)
    {
      hiding.firstHidesSecond = hiding.firstHidesSecond && place > reachA.lower * eye.w;
      hiding.secondHidesFirst = hiding.secondHidesFirst && place < reachB.upper * eye.w;
    }
  }
  return hiding;
}

double CommonPixels(const Viewport& a, const Viewport& b)
{
  const auto common = [](int beginA, int countA, int beginB, int countB)
  { return std::max(std::min(beginA + countA, beginB + countB) - std::max(beginA, beginB), 0); };
  return double(common(a.left, a.width, b.left, b.width)) *
    common(a.bottom, a.height, b.bottom, b.height);
}

// The pixels in which each owner, by row, may hide each other, by column.
std::vector<double> HiddenPixels(
  const std::vector<OwnedBox>& boxes, int ownerCount, const glm::dmat4& clipFromWorld)
{
  std::vector<double> hidden(std::size_t(ownerCount) * ownerCount, 0.0);
  const glm::dvec4 eye = EyeOf(clipFromWorld);
  std::vector<Solid> solids;
  for (const OwnedBox& box : boxes)
  {
    const Solid solid = SolidOf(box, clipFromWorld);
    for (const Solid& other : solids)
    {
      const double pixels = CommonPixels(solid.pixels, other.pixels);
      if (solid.owner == other.owner || pixels == 0.0)
      {
        continue;
      }
      const Hiding hiding = HidingOf(solid, other, eye);
      hidden[std::size_t(solid.owner) * ownerCount + other.owner] +=
        hiding.firstHidesSecond ? pixels : 0.0;
      hidden[std::size_t(other.owner) * ownerCount + solid.owner] +=
        hiding.secondHidesFirst ? pixels : 0.0;
    }
    solids.push_back(solid);
  }
  return hidden;
}

}

OwnerOrder OwnersFrontToBack(
  const std::vector<OwnedBox>& boxes, int ownerCount, const glm::dmat4& clipFromWorld)
{
  const std::vector<double> hidden = HiddenPixels(boxes, ownerCount, clipFromWorld);
  const auto hiddenBy = [&](int owner, int other)
  { return hidden[std::size_t(owner) * ownerCount + other]; };
  std::vector<double> hiddenByRest(ownerCount, 0.0);
  for (int owner = 0; owner < ownerCount; ++owner)
  {
    for (int other = 0; other < ownerCount; ++other)
    {
      hiddenByRest[other] += hiddenBy(owner, other);
    }
  }
  std::vector<int> rest(ownerCount);
  std::iota(rest.begin(), rest.end(), 0);
  OwnerOrder order;
  while (!rest.empty())
  {
    const auto next = std::min_element(
      rest.begin(), rest.end(), [&](int a, int b) { return hiddenByRest[a] < hiddenByRest[b]; });
    const int owner = *next;
    rest.erase(next);
    order.owners.push_back(owner);
    for (int other : rest)
    {
      hiddenByRest[other] -= hiddenBy(owner, other); // whole numbers, without rounding
      if (!order.conflict && hiddenBy(other, owner) > 0.0)
      {
        order.conflict = std::pair(owner, other);
      }
    }
  }
  return order;
}

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
