#ifndef Varimarch_Core_Packets_Reach_Casters_h
#define Varimarch_Core_Packets_Reach_Casters_h

// Twin of Casters/Triangles.glsl: opaque geometry that takes light from a volume.

#include "Core/Packets/Cone/Disc.h"
#include "Core/Packets/Reach/MeetTriangles.h"
#include "Core/Packets/Reach/ShadowRays.h"

namespace varimarch
{

namespace
{

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
