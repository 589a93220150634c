#ifndef Varimarch_Core_Packets_Reach_ShadowRays_h
#define Varimarch_Core_Packets_Reach_ShadowRays_h

// Twin of Reach/ShadowRays.glsl and Through/Segments.glsl.

#include "Core/Packets/Reach/MatterAlong.h"
#include "Core/Packets/Shade/Lights.h"
#include "Core/Packets/Step/OpticalField.h"

#include <algorithm>

namespace varimarch
{

namespace
{

/// How far and how exactly rays to lights are marched.
struct ShadowMarch
{
  float longestMm; ///< longest segment
  Lanes firstMm;   ///< first segment
  float mostDepth; ///< optical depth beyond which no light is left
};

/// Tells ShadowDepth no depths, so that it takes those of the rays themselves.
struct NothingIsKnown
{
  template <class Extinction>
  LaneMask operator()(Lanes, const Lanes&, LaneMask, const Extinction&) const
  {
    return LaneMask{};
  }
};

/// The optical depth of the volume along rays of any origin.
template <class Voxels>
class ShadowDepth
{
public:
  ShadowDepth(const PacketScene& scene, const Voxels& voxels, const PacketRays& rays,
    const ShadowMarch& march)
    : scene(scene)
    , voxels(voxels)
    , rays(rays)
    , march(march)
    , walk(scene, rays, 0, 0)
    , matter(scene, rays)
    , t(rays.enter)
    , plainMm(march.firstMm)
    , endValue(voxels.ValueAt(rays.At(rays.enter)))
  {
  }

  /// @param mask   the rays whose depth matters
  /// @param known  (places along the rays, depths up to there, rays, extinction there) -> the rays
  ///               whose further depth is known, after adding it to the depths. The extinction is a
  ///               function of the rays at whose places it matters.
  template <class Known>
  Lanes Along(LaneMask mask, Known known)
  {
    mask &= LaneMask(this->t < this->rays.exit);
    for (int index = 0; index < this->scene.rays.mostSegments && Any(mask); ++index)
    {
      mask &= ~known(
        this->t, this->depth, mask, [&](LaneMask asked) { return this->ExtinctionHere(asked); });
      if (!Any(mask))
      {
        break;
      }
      this->AddSegment(mask);
      mask &= LaneMask(this->t < this->rays.exit) & LaneMask(this->depth < this->march.mostDepth);
    }
    return this->depth;
  }

  /// The extinction where the rays are [1/mm].
  Lanes ExtinctionHere(LaneMask mask)
  {
    LaneMask absorbs = mask & MayAbsorb(this->scene.look, this->endValue, this->endValue);
    if (Any(absorbs))
    {
      this->matter.GoTo(this->t, absorbs);
      absorbs &= this->matter.IsLeft(this->t);
    }
    return Any(absorbs)
      ? Select(absorbs,
          this->matter.ExtinctionOf(this->endValue, this->GradientAt(this->t, absorbs)), Lanes{})
      : Lanes{};
  }

private:
  void AddSegment(LaneMask mask)
  {
    const SegmentLanes next = this->walk.NextOfBricks(this->t, this->plainMm, mask);
    const LaneMask jumps = LaneMask(next.enter > this->t);
    const Lanes uncut = Min(next.exit, this->matter.GoTo(this->t, mask));
    const Lanes end = Min(Select(jumps, next.enter, uncut), this->rays.exit);
    const Lanes lengthMm = Select(jumps, Lanes{}, Max(end - next.enter, Lanes{}));
    const Lanes startValue = this->endValue;
    this->endValue = Select(mask, this->voxels.ValueAt(this->rays.At(end)), this->endValue);
    LaneMask absorbs =
      mask & LaneMask(lengthMm > 0.0f) & MayAbsorb(this->scene.look, startValue, this->endValue);
    if (Any(absorbs))
    {
      absorbs &= this->matter.IsLeft(end - 0.5f * lengthMm);
    }
    if (Any(absorbs))
    {
      const Lanes added = lengthMm *
        this->matter.MeanExtinctionOf(startValue, this->endValue, this->GradientAt(end, absorbs));
      this->depth = this->depth + Select(absorbs, added, Lanes{});
    }
    this->t = Select(mask, end, this->t);
    const Lanes longer = NextShadowStep(this->plainMm, All(this->march.longestMm));
    this->plainMm = Select(jumps, this->plainMm, longer);
  }

  // The gradient at a place, where extinction depends on it.
  Lanes3 GradientAt(Lanes place, LaneMask mask) const
  {
    return this->matter.IsOfValues() ? Lanes3(0.0f)
                                     : this->voxels.SlopeAt(this->rays.At(place), mask).gradient;
  }

  const PacketScene& scene;
  const Voxels& voxels;
  const PacketRays& rays;
  const ShadowMarch& march;
  PacketWalk walk;
  MatterAlong matter;
  Lanes t;
  Lanes plainMm;
  Lanes endValue;
  Lanes depth = {};
};

/// Keeps the parts of rays inside the volume that clipping planes leave.
inline void KeepUncut(PacketRays& rays, const PacketScene& scene)
{
  KeepInside(rays, scene.parameters.ownLowerGrid, scene.parameters.ownUpperGrid);
  for (int plane = 0; plane < scene.rays.clippingPlaneCount; ++plane)
  {
    KeepBeyond(rays, scene.rayTextures.clippingPlanes[plane]);
  }
  rays.exit = Max(rays.exit, rays.enter);
}

/// One of the lights that cast shadows.
class ShadowedLight
{
public:
  static int CountOf(const PacketScene& scene)
  {
    const VolumeParameters& p = scene.parameters;
    return scene.light.castsShadows ? std::min(p.distantCount + p.nearCount, MostShadowedLights)
                                    : 0;
  }

  /// @param light  in the order of lightTexels
  ShadowedLight(const PacketScene& scene, int light)
    : scene(scene)
    , isDistant(light < scene.parameters.distantCount)
    , texel(scene.textures.lightTexels[light * PacketLights::TexelsPerLight])
  {
  }

  /// 1 - the cosine of half the angle of its cone; 0: it is a point.
  float ConeHeight() const { return this->texel.w; }

  /// The way from places to its middle.
  struct Way
  {
    Lanes3 towardsWorld; ///< unit vectors
    Lanes distanceMm;
  };

  Way WayFrom(const Lanes3& originGrid) const
  {
    const VolumeParameters& p = this->scene.parameters;
    const Lanes3 positionWorld =
      Transformed(p.worldFromGrid, originGrid) + AllOf3(p.worldOfGridOrigin);
    const Lanes3 toLight =
      this->isDistant ? AllOf3(this->texel) : AllOf3(this->texel) - positionWorld;
    const Lanes distanceMm = Max(Length(toLight), 1e-15f);
    return { (1.0f / distanceMm) * toLight,
      Min(this->isDistant ? All(Never) : distanceMm, All(p.shadowReachMm)) };
  }

  /// The rays to its middle, as far as the volume and its clipping planes leave them.
  PacketRays RaysFrom(const Lanes3& originGrid) const
  {
    return this->RaysFrom(originGrid, [](const Lanes3& towards) { return towards; });
  }

  /// Such rays to another place in its cone.
  /// @param turned  (unit vectors to its middle) -> those to the other place
  template <class Turned>
  PacketRays RaysFrom(const Lanes3& originGrid, Turned turned) const
  {
    const Way way = this->WayFrom(originGrid);
    PacketRays rays;
    rays.originGrid = originGrid;
    rays.directionGrid =
      Transformed(this->scene.parameters.gridFromWorld, turned(way.towardsWorld));
    rays.inverse = SafeInverse(rays.directionGrid);
    rays.region = IntLanes{};
    rays.enter = Lanes{};
    rays.exit = way.distanceMm;
    KeepUncut(rays, this->scene);
    return rays;
  }

private:
  const PacketScene& scene;
  bool isDistant;
  const glm::vec4& texel;
};

}

}

#endif
