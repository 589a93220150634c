#include "Core/Geometry/TriangleTree.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace varimarch
{

namespace
{

using glm::abs;
using glm::cross;
using glm::dot;
using glm::max;
using glm::min;
using glm::step;
using glm::vec2;
using glm::vec3;
#include "Shaders/Math/IntersectBox.glsl"
#include "Shaders/Math/RayTriangle.glsl"

constexpr std::ptrdiff_t MostTrianglesOfNode = 4;

struct Corners
{
  glm::vec3 lower = glm::vec3(std::numeric_limits<float>::max());
  glm::vec3 upper = glm::vec3(std::numeric_limits<float>::lowest());

  void Add(glm::vec3 position)
  {
    this->lower = glm::min(this->lower, position);
    this->upper = glm::max(this->upper, position);
  }
};

glm::vec3 MiddleOf(const Triangle& triangle)
{
  return (triangle[0] + triangle[1] + triangle[2]) / 3.0f;
}

bool CanBeMet(const Triangle& triangle)
{
  const glm::dvec3 first(triangle[0]);
  const glm::dvec3 normal =
    glm::cross(glm::dvec3(triangle[1]) - first, glm::dvec3(triangle[2]) - first);
  const double area = glm::dot(normal, normal);
  return area > 0.0 && std::isfinite(area);
}

void PutTriangle(glm::vec4* texel, const Triangle& corners)
{
  texel[0] = glm::vec4(corners[0], texel[0].w);
  texel[1] = glm::vec4(corners[1] - corners[0], texel[1].w);
  texel[2] = glm::vec4(corners[2] - corners[0], texel[2].w);
}

// Puts the half of things with the smaller middles along the longest side first.
// @param middleOf  (thing) -> place
// @return the first thing of the other half
template <class Thing, class Middle>
Thing* Halve(Thing* begin, Thing* end, const Middle& middleOf)
{
  Corners middles;
  std::for_each(begin, end, [&](const Thing& one) { middles.Add(middleOf(one)); });
  const glm::vec3 size = middles.upper - middles.lower;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  Thing* const half = begin + (end - begin) / 2;
  std::nth_element(begin, half, end,
    [&](const Thing& a, const Thing& b) { return middleOf(a)[axis] < middleOf(b)[axis]; });
  return half;
}

}

TriangleTree::TriangleTree(const TriangleGroups& all)
{
  std::size_t count = 0;
  for (const std::vector<Triangle>& group : all)
  {
    this->groups.push_back({ count, 0, 0, 0, 0 });
    count += group.size();
  }
  if (count > MostTriangles)
  {
    throw std::invalid_argument("A tree has " + std::to_string(count) +
      " triangles: expected at most " + std::to_string(MostTriangles));
  }
  std::vector<Sorted> sorted = this->SortedGroups(all);
  this->AddGroups(sorted.data(), sorted.data() + sorted.size());
  this->PlaceTriangles();
  this->FitBoxes(0, std::size_t(this->texels[0].w));
}

// The groups with any triangle that can be met.
std::vector<TriangleTree::Sorted> TriangleTree::SortedGroups(const TriangleGroups& all)
{
  std::vector<Sorted> sorted;
  for (std::size_t group = 0; group < all.size(); ++group)
  {
    std::vector<Numbered> met;
    met.reserve(all[group].size());
    for (std::size_t i = 0; i < all[group].size(); ++i)
    {
      if (CanBeMet(all[group][i]))
      {
        met.push_back({ all[group][i], this->groups[group].firstNumber + i });
      }
    }
    if (!met.empty())
    {
      sorted.push_back(SortedOf(group, std::move(met)));
    }
  }
  return sorted;
}

TriangleTree::Sorted TriangleTree::SortedOf(std::size_t group, std::vector<Numbered> triangles)
{
  Sort(triangles.data(), triangles.data() + triangles.size());
  Corners corners;
  for (const Numbered& one : triangles)
  {
    corners.Add(MiddleOf(one.corners));
  }
  return { group, std::move(triangles), 0.5f * (corners.lower + corners.upper) };
}

// Each call has half of the triangles of the one above it, so that there are at most 21 of them.
void TriangleTree::Sort(Numbered* begin, Numbered* end)
{
  constexpr std::ptrdiff_t LeastForTwoCores = 8192;
  if (end - begin <= MostTrianglesOfNode)
  {
    return;
  }
  Numbered* const half =
    Halve(begin, end, [](const Numbered& one) { return MiddleOf(one.corners); });
  if (end - begin < LeastForTwoCores)
  {
    Sort(begin, half);
    Sort(half, end);
    return;
  }
  tbb::parallel_invoke([=] { Sort(begin, half); }, [=] { Sort(half, end); });
}

void TriangleTree::AddGroups(Sorted* begin, Sorted* end)
{
  if (end - begin == 1)
  {
    Group& group = this->groups[begin->group];
    group.firstNode = this->texels.size() / 2;
    group.firstTexel = this->triangles.size();
    const Numbered* const first = begin->triangles.data();
    this->AddNodes(first, first + begin->triangles.size());
    group.endNode = this->texels.size() / 2;
    group.endTexel = this->triangles.size();
    return;
  }
  const std::size_t node = this->AddNode(-1.0f);
  this->nodesOfGroups.push_back(node);
  if (begin != end)
  {
    Sorted* const half = Halve(begin, end, [](const Sorted& one) { return one.middle; });
    this->AddGroups(begin, half);
    this->AddGroups(half, end);
  }
  this->CloseNode(node);
}

// @param firstTriangle  its texel among those of triangles; below 0 if the node has nodes
std::size_t TriangleTree::AddNode(float firstTriangle)
{
  this->texels.emplace_back(0.0f);
  this->texels.emplace_back(glm::vec3(0.0f), firstTriangle);
  return this->texels.size() / 2 - 1;
}

void TriangleTree::CloseNode(std::size_t node)
{
  this->texels[2 * node].w = float(this->texels.size() / 2);
}

// The nodes of triangles that are sorted.
void TriangleTree::AddNodes(const Numbered* begin, const Numbered* end)
{
  const bool hasTriangles = end - begin <= MostTrianglesOfNode;
  const std::size_t node = this->AddNode(hasTriangles ? float(this->triangles.size()) : -1.0f);
  if (hasTriangles)
  {
    for (const Numbered* one = begin; one != end; ++one)
    {
      this->triangles.emplace_back(glm::vec3(0.0f), one + 1 == end ? 1.0f : 0.0f);
      this->triangles.emplace_back(glm::vec3(0.0f), float(one->number));
      this->triangles.emplace_back(0.0f);
      PutTriangle(&this->triangles.back() - 2, one->corners);
    }
  }
  else
  {
    const Numbered* const half = begin + (end - begin) / 2;
    this->AddNodes(begin, half);
    this->AddNodes(half, end);
  }
  this->CloseNode(node);
}

// Puts the triangles behind the nodes, whose number is known when all are made.
void TriangleTree::PlaceTriangles()
{
  const std::size_t behind = this->texels.size();
  for (std::size_t node = 0; node < behind; node += 2)
  {
    float& first = this->texels[node + 1].w;
    first = first < 0.0f ? 0.0f : first + float(behind);
  }
  for (Group& group : this->groups)
  {
    group.firstTexel += behind;
    group.endTexel += behind;
  }
  this->texels.insert(this->texels.end(), this->triangles.begin(), this->triangles.end());
  this->triangles = {};
}

void TriangleTree::FitBox(std::size_t node)
{
  Corners corners;
  glm::vec4& lower = this->texels[2 * node];
  glm::vec4& upper = this->texels[2 * node + 1];
  bool isLast = !(upper.w > 0.0f);
  for (auto texel = std::size_t(upper.w); !isLast; texel += 3)
  {
    const glm::vec3 first(this->texels[texel]);
    corners.Add(first);
    corners.Add(first + glm::vec3(this->texels[texel + 1]));
    corners.Add(first + glm::vec3(this->texels[texel + 2]));
    isLast = this->texels[texel].w > 0.0f;
  }
  const std::size_t end = upper.w > 0.0f ? 0 : std::size_t(lower.w);
  for (std::size_t inner = node + 1; inner < end; inner = std::size_t(this->texels[2 * inner].w))
  {
    corners.Add(glm::vec3(this->texels[2 * inner]));
    corners.Add(glm::vec3(this->texels[2 * inner + 1]));
  }
  lower = glm::vec4(corners.lower, lower.w);
  upper = glm::vec4(corners.upper, upper.w);
}

// A node comes before those in it.
void TriangleTree::FitBoxes(std::size_t firstNode, std::size_t endNode)
{
  for (std::size_t node = endNode; node > firstNode; --node)
  {
    this->FitBox(node - 1);
  }
}

bool TriangleTree::Move(std::size_t group, const std::vector<Triangle>& moved)
{
  const Group& one = this->groups[group];
  const auto cornersAt = [&](std::size_t texel) -> const Triangle&
  { return moved[std::size_t(this->texels[texel + 1].w) - one.firstNumber]; };
  const auto haveArea = std::count_if(moved.begin(), moved.end(), CanBeMet);
  if (std::size_t(haveArea) != (one.endTexel - one.firstTexel) / 3)
  {
    return false;
  }
  for (std::size_t texel = one.firstTexel; texel < one.endTexel; texel += 3)
  {
    if (!CanBeMet(cornersAt(texel)))
    {
      return false;
    }
  }
  for (std::size_t texel = one.firstTexel; texel < one.endTexel; texel += 3)
  {
    PutTriangle(&this->texels[texel], cornersAt(texel));
  }
  this->FitBoxes(one.firstNode, one.endNode);
  std::for_each(this->nodesOfGroups.rbegin(), this->nodesOfGroups.rend(),
    [this](std::size_t node) { this->FitBox(node); });
  return true;
}

std::optional<TriangleHit> NearestTriangle(
  const glm::vec4* tree, glm::vec3 origin, glm::vec3 direction, float exit)
{
  TriangleHit nearest = { exit, 0 };
  bool isMet = false;
  const glm::vec3 inverse = SafeInverse(direction);
  const auto nodeCount = std::size_t(tree[0].w);
  std::size_t node = 0;
  while (node < nodeCount)
  {
    const glm::vec4& lower = tree[2 * node];
    const glm::vec4& upper = tree[2 * node + 1];
    if (EntersBox(IntersectBox(origin, inverse, lower, upper), nearest.t) < 0.0f)
    {
      node = std::size_t(lower.w);
      continue;
    }
    bool isLast = !(upper.w > 0.0f);
    for (auto texel = std::size_t(upper.w); !isLast; texel += 3)
    {
      const glm::vec4* const one = tree + texel;
      const float t = DistanceToTriangle(origin, direction, one[0], one[1], one[2]);
      if (t > 0.0f && t < nearest.t)
      {
        nearest = { t, std::size_t(one[1].w) };
        isMet = true;
      }
      isLast = one[0].w > 0.0f;
    }
    ++node;
  }
  return isMet ? std::optional<TriangleHit>(nearest) : std::nullopt;
}

}
