#ifndef Varimarch_Core_Packets_Reach_MeetTriangles_h
#define Varimarch_Core_Packets_Reach_MeetTriangles_h

// Whether rays meet the triangles of a TriangleTree.

#include "Core/Packets/ShaderMath.h"

#include <glm/vec4.hpp>

namespace varimarch
{

namespace
{

/// Rays in the space of a TriangleTree; the direction has any length.
struct TreeRays
{
  Lanes3 origin;
  Lanes3 direction;
  Lanes exit; ///< the length of the ray
};

/// The rays that meet triangles from a texel of a TriangleTree on.
inline LaneMask MeetTrianglesOfNode(const glm::vec4* triangle, const TreeRays& rays, LaneMask mask)
{
  LaneMask met = {};
  for (bool isLast = false; !isLast; triangle += 3)
  {
    const Lanes t = DistanceToTriangle(
      rays.origin, rays.direction, AllOf3(triangle[0]), AllOf3(triangle[1]), AllOf3(triangle[2]));
    met |= mask & LaneMask(t > 0.0f) & LaneMask(t < rays.exit);
    isLast = triangle[0].w > 0.0f;
  }
  return met;
}

/// The rays of a mask that meet a triangle before their exits.
[[gnu::noinline]] inline LaneMask MeetTriangles(
  const glm::vec4* tree, const TreeRays& rays, LaneMask mask)
{
  const int nodeCount = int(tree[0].w);
  const Lanes3 inverse = SafeInverse(rays.direction);
  LaneMask met = {};
  int node = 0;
  while (node < nodeCount && Any(mask & ~met))
  {
    const glm::vec4& lower = tree[2 * node];
    const glm::vec4& upper = tree[2 * node + 1];
    const Lanes2 inside = IntersectBox(rays.origin, inverse, AllOf3(lower), AllOf3(upper));
    const LaneMask enters = mask & ~met & LaneMask(EntersBox(inside, rays.exit) > 0.0f);
    if (!Any(enters))
    {
      node = int(lower.w);
      continue;
    }
    if (upper.w > 0.0f)
    {
      met |= MeetTrianglesOfNode(tree + int(upper.w), rays, enters);
    }
    ++node;
  }
  return met;
}

}

}

#endif
