#include "Core/Geometry/TriangleTree.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

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

}

TriangleTree::TriangleTree(const std::vector<Triangle>& all)
{
  if (all.size() > MostTriangles)
  {
    throw std::invalid_argument("A tree has " + std::to_string(all.size()) +
      " triangles: expected at most " + std::to_string(MostTriangles));
  }
  std::vector<Numbered> met;
  met.reserve(all.size());
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    if (CanBeMet(all[i]))
    {
      met.push_back({ all[i], i });
    }
  }
  this->AddNode(met.data(), met.data() + met.size());
  // Triangles come behind the nodes, whose number is known only now.
  for (std::size_t node = 0; node < this->texels.size(); node += 2)
  {
    float& first = this->texels[node + 1].w;
    first = first < 0.0f ? 0.0f : first + float(this->texels.size());
  }
  this->texels.insert(this->texels.end(), this->triangles.begin(), this->triangles.end());
  this->triangles = {};
}

// Puts the half of the triangles with the smaller middles along the longest side first.
TriangleTree::Numbered* TriangleTree::Halve(Numbered* begin, Numbered* end)
{
  Corners middles;
  std::for_each(begin, end, [&](const Numbered& one) { middles.Add(MiddleOf(one.corners)); });
  const glm::vec3 size = middles.upper - middles.lower;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  Numbered* const half = begin + (end - begin) / 2;
  std::nth_element(begin, half, end,
    [axis](const Numbered& a, const Numbered& b)
    { return MiddleOf(a.corners)[axis] < MiddleOf(b.corners)[axis]; });
  return half;
}

// Each call has half of the triangles of the one above it, so that there are at most 21 of them.
void TriangleTree::AddNode(Numbered* begin, Numbered* end)
{
  Corners corners;
  for (const Numbered* one = begin; one != end; ++one)
  {
    std::for_each(one->corners.begin(), one->corners.end(),
      [&](const glm::vec3& corner) { corners.Add(corner); });
  }
  const bool hasTriangles = begin != end && end - begin <= MostTrianglesOfNode;
  const std::size_t node = this->texels.size();
  this->texels.emplace_back(corners.lower, 0.0f);
  this->texels.emplace_back(corners.upper, hasTriangles ? float(this->triangles.size()) : -1.0f);
  if (hasTriangles)
  {
    this->AddTriangles(begin, end);
  }
  else if (begin != end)
  {
    Numbered* const half = Halve(begin, end);
    this->AddNode(begin, half);
    this->AddNode(half, end);
  }
  this->texels[node].w = float(this->texels.size() / 2);
}

void TriangleTree::AddTriangles(const Numbered* begin, const Numbered* end)
{
  for (const Numbered* one = begin; one != end; ++one)
  {
    const glm::vec3 first = one->corners[0];
    this->triangles.emplace_back(first, one + 1 == end ? 1.0f : 0.0f);
    this->triangles.emplace_back(one->corners[1] - first, float(one->number));
    this->triangles.emplace_back(one->corners[2] - first, 0.0f);
  }
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
