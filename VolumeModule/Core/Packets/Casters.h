#ifndef Varimarch_Core_Packets_Casters_h
#define Varimarch_Core_Packets_Casters_h

// Opaque geometry that takes light from a volume.
// Twin of Cone/Disc.glsl and Casters/Triangles.glsl.

#include "Core/Geometry/LightCone.h"
#include "Core/Packets/LightRays.h"
#include "Core/Packets/ShaderMath.h"

#include <glm/vec4.hpp>

namespace varimarch
{

namespace
{

/// The mean of the light over the directions in a cone.
/// @param height       1 - the cosine of the cone's half angle
/// @param transmitted  receives a function that turns unit vectors to the middle of the light into
/// those to another place in it, and returns the light that arrives from there
template <class Transmitted>
Lanes MeanOverCone(float height, Transmitted transmitted)
{
  Lanes sum = {};
  for (const DiscPoint& point : DiscQuadrature())
  {
    const auto turned = [&](const Lanes3& towards)
    { return DirectionInCone(towards, All(height), All(float(point.x)), All(float(point.y))); };
    sum = sum + float(point.weight) * transmitted(turned);
  }
  return sum;
}

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

/// The opaque geometry between a light and places in a volume.
class Casters
{
public:
  /// @param light  its index
  Casters(const PacketScene& scene, int light)
    : scene(scene)
    , light(scene, light)
    , tree(scene.rayTextures.casterTree.Texels<glm::vec4>())
  {
  }

  /// True if the scene has geometry that casts shadows.
  static bool AreIn(const PacketScene& scene) { return bool(scene.rayTextures.casterTree); }

  /// The places that no geometry hides from the middle of the light.
  LaneMask Leave(const Lanes3& placeGrid, LaneMask mask) const
  {
    return this->Leave(placeGrid, mask, [](const Lanes3& towards) { return towards; });
  }

  /// The same for another place in the light's cone.
  /// @param turned  (unit vectors to its middle) -> those to the other place
  template <class Turned>
  LaneMask Leave(const Lanes3& placeGrid, LaneMask mask, Turned turned) const
  {
    const VolumeParameters& p = this->scene.parameters;
    const ShadowedLight::Way way = this->light.WayFrom(placeGrid);
    const TreeRays rays = { Transformed(p.worldFromGrid, placeGrid) + AllOf3(p.originInCasters),
      turned(way.towardsWorld), way.distanceMm };
    return mask & ~MeetTriangles(this->tree, rays, mask);
  }

  /// The part of the light's cone that no geometry hides, [0, 1].
  Lanes PartOfCone(const Lanes3& placeGrid, LaneMask mask) const
  {
    return MeanOverCone(this->light.ConeHeight(),
      [&](const auto& turned)
      { return Select(this->Leave(placeGrid, mask, turned), All(1.0f), Lanes{}); });
  }

private:
  const PacketScene& scene;
  ShadowedLight light;
  const glm::vec4* tree;
};

/// The parts of the rays of a packet that lie in the shadow of geometry. Along a ray, light that is
/// a point begins and ends at once, so that its edges are searched for. A ray is examined at places
/// that are shadowStepMm apart, and where two of these differ, the edge between them is bisected.
class CasterEdges
{
public:
  /// The lit fraction of parts of the rays, which follow each other.
  /// @param leave  (t, mask) -> the rays that are lit at t
  template <class Leave>
  Lanes LitFraction(
    const PacketRays& rays, Lanes from, Lanes to, LaneMask mask, float stepMm, const Leave& leave)
  {
    const LaneMask goesOn =
      this->isKnown & LaneMask(from >= this->begin) & LaneMask(from <= this->end);
    const LaneMask moves = mask & ~(goesOn & LaneMask(to <= this->end));
    if (Any(moves))
    {
      this->Move(moves, moves & goesOn, from, Max(to, Min(from + stepMm, rays.exit)), leave);
    }
    const Lanes inside = Clamp(this->edge, from, to);
    const Lanes lit = Select(this->isLitAtBegin, inside - from, Lanes{}) +
      Select(this->isLitAtEnd, to - inside, Lanes{});
    return Clamp(lit / Max(to - from, 1e-30f), 0.0f, 1.0f);
  }

private:
  static constexpr int Bisections = 7;

  // Examines the rays of a mask between two places.
  // @param goesOn  the rays whose light at the first place is known
  template <class Leave>
  [[gnu::noinline]] void Move(
    LaneMask mask, LaneMask goesOn, Lanes from, Lanes to, const Leave& leave)
  {
    const LaneMask known =
      Select(LaneMask(from < this->edge), this->isLitAtBegin, this->isLitAtEnd);
    const LaneMask asked = mask & ~goesOn;
    const LaneMask litAtBegin = (goesOn & known) | (Any(asked) ? leave(from, asked) : LaneMask{});
    const LaneMask litAtEnd = leave(to, mask);
    Lanes lower = from;
    Lanes upper = to;
    const LaneMask differs = mask & (litAtBegin ^ litAtEnd);
    for (int i = 0; i < Bisections && Any(differs); ++i)
    {
      const Lanes middle = 0.5f * (lower + upper);
      const LaneMask isBefore = ~(leave(middle, differs) ^ litAtBegin);
      lower = Select(isBefore, middle, lower);
      upper = Select(isBefore, upper, middle);
    }
    this->begin = Select(mask, from, this->begin);
    this->end = Select(mask, to, this->end);
    this->edge = Select(mask, 0.5f * (lower + upper), this->edge);
    this->isLitAtBegin = Select(mask, litAtBegin, this->isLitAtBegin);
    this->isLitAtEnd = Select(mask, litAtEnd, this->isLitAtEnd);
    this->isKnown |= mask;
  }

  Lanes begin = {}; ///< the places on the rays that were examined last [mm]
  Lanes end = {};
  Lanes edge = {}; ///< the edge of the shadow between them; anywhere between if there is none
  LaneMask isLitAtBegin = {};
  LaneMask isLitAtEnd = {};
  LaneMask isKnown = {}; ///< the rays that were examined
};

/// The shadows that geometry casts on the rays of a packet, of lights that are points.
class CastersOnRays
{
public:
  CastersOnRays(const PacketScene& scene, const PacketRays& rays)
    : scene(scene)
    , rays(rays)
  {
  }

  /// How much an eye sees of a light on a part of the rays that geometry leaves.
  Lanes Left(int light, Lanes seen, const RayPart& part, LaneMask isSeen)
  {
    if (!Casters::AreIn(this->scene) || ShadowedLight(this->scene, light).ConeHeight() > 0.0f)
    {
      return seen;
    }
    const Casters casters(this->scene, light);
    const Lanes half = 0.5f * part.lengthMm;
    return seen *
      this->edges[light].LitFraction(this->rays, part.t - half, part.t + half, isSeen,
        this->scene.rays.shadowStepMm,
        [&](Lanes t, LaneMask mask) { return casters.Leave(this->rays.At(t), mask); });
  }

private:
  const PacketScene& scene;
  const PacketRays& rays;
  CasterEdges edges[MostShadowedLights];
};

}

}

#endif
