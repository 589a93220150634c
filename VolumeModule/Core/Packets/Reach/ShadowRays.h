#ifndef Varimarch_Core_Packets_Reach_ShadowRays_h
#define Varimarch_Core_Packets_Reach_ShadowRays_h

// Twin of Reach/ShadowRays.glsl and Through/Segments.glsl.

#include "Core/Packets/Interpolation/AnyVoxels.h"
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

class TracedLight;

/// An optical depth that a lattice of light tells.
struct KnownDepth
{
  LaneMask isKnown; ///< the rays whose further depth is known
  Lanes depth;      ///< of these rays with the further depth, of others as before
};

/// @param depth  up to the places
/// @param taken  the optical depth of a cell that is filled by the matter at the places
KnownDepth DepthOfCells(
  const TracedLight& light, const Lanes3& placeGrid, Lanes depth, LaneMask mask, Lanes taken);

/// The depths of rays to a light that its lattice tells.
class KnownDepths
{
public:
  /// None, so that the rays themselves are marched.
  explicit KnownDepths(const PacketRays& rays)
    : rays(rays)
  {
  }

  /// @param light   with a lattice
  /// @param cellMm  length of a cell along the rays
  KnownDepths(const TracedLight& light, const PacketRays& rays, Lanes cellMm)
    : light(&light)
    , rays(rays)
    , cellMm(cellMm)
  {
  }

  /// Cells are read where a ray begins, and then ever farther apart.
  /// @param extinction  (rays) -> the extinction at their t
  template <class Extinction>
  KnownDepth At(Lanes t, Lanes depth, LaneMask mask, const Extinction& extinction)
  {
    if (!this->light)
    {
      return { LaneMask{}, depth };
    }
    const LaneMask asks = mask & LaneMask(t >= this->next);
    if (!Any(asks))
    {
      return { LaneMask{}, depth };
    }
    this->next = Select(asks, Max(2.0f * t, t + this->cellMm), this->next);
    return DepthOfCells(
      *this->light, this->rays.At(t), depth, asks, this->cellMm * extinction(asks));
  }

private:
  const TracedLight* light = nullptr;
  const PacketRays& rays;
  Lanes cellMm = {};
  Lanes next = {}; ///< the place where a cell is read next
};

/// The optical depth of the volume along rays of any origin.
/// @tparam Voxels  PacketVoxels or AnyVoxels
template <class Voxels>
class ShadowDepth
{
public:
  ShadowDepth(const PacketScene& scene, const PacketRays& rays, const ShadowMarch& march)
    : scene(scene)
    , voxels(scene)
    , rays(rays)
    , march(march)
    , walk(scene, rays, 0, 0)
    , matter(scene, rays)
    , t(rays.enter)
    , plainMm(march.firstMm)
    , endValue(voxels.ValueAt(rays.At(rays.enter)))
  {
  }

  /// @param mask  the rays whose depth matters
  Lanes Along(LaneMask mask, KnownDepths known)
  {
    mask &= LaneMask(this->t < this->rays.exit);
    for (int index = 0; index < this->scene.rays.mostSegments && Any(mask); ++index)
    {
      const KnownDepth further = known.At(
        this->t, this->depth, mask, [&](LaneMask asked) { return this->ExtinctionHere(asked); });
      this->depth = further.depth;
      mask &= ~further.isKnown;
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
  Voxels voxels;
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
