#ifndef Varimarch_Core_Packets_LightRays_h
#define Varimarch_Core_Packets_LightRays_h

// Rays to lights: the matter that takes light along rays of any origin.
// Twin of Reach/ShadowRays.glsl, Through/Segments.glsl and Through/Voxels.glsl.

#include "Core/Fields/GapField.h"
#include "Core/Packets/AnyVoxels.h"
#include "Core/Packets/Cuts.h"
#include "Core/Packets/Looks.h"
#include "Core/Packets/Materials.h"
#include "Core/Packets/Shade.h"
#include "Core/Packets/Walk.h"

#include <algorithm>

namespace varimarch
{

namespace
{

/// The matter that cropping, a mask and gaps leave along rays that are followed forwards.
class MatterAlong
{
public:
  MatterAlong(const PacketScene& scene, const PacketRays& rays)
    : scene(scene)
    , rays(rays)
    , material(scene, rays)
    , looks(scene)
    , mask(scene, rays)
    , isCut(
        scene.rays.croppingRegions != 0 || scene.textures.maskTexture || scene.textures.gapTexture)
  {
  }

  /// Goes on to t. Returns the next place at which cropping or the mask may cut the rays.
  /// @param isAsked  the rays that matter
  Lanes GoTo(Lanes t, LaneMask isAsked)
  {
    return this->isCut ? this->GoToCut(t, isAsked) : All(Never);
  }

  /// The rays with matter at a place, which lies before the next cut.
  LaneMask IsLeft(Lanes place) const
  {
    return this->isCut ? this->IsLeftByCuts(place) : LaneMask(place == place);
  }

  /// True if extinction depends on values alone.
  bool IsOfValues() const
  {
    return !this->scene.textures.gradientOpacityTable && !this->scene.textures.twoValueTable;
  }

  /// The extinction of values where the rays are [1/mm].
  Lanes ExtinctionOf(Lanes value, const Lanes3& gradient) const
  {
    if (this->scene.labelRows)
    {
      return this->ExtinctionOfLabels(value, gradient);
    }
    const Lanes extinction = this->IsOfValues() ? varimarch::ExtinctionOf(this->scene.look, value)
                                                : this->ExtinctionBy(value, gradient);
    const float weight = this->scene.parameters.partWeights[this->scene.constituent.component];
    return Min(weight * extinction, All(this->scene.shadows.mostExtinction));
  }

  /// The mean extinction of values that change linearly from one to another [1/mm].
  Lanes MeanExtinctionOf(Lanes start, Lanes end, const Lanes3& gradient) const
  {
    if (this->scene.look.sums && !this->scene.labelRows && this->IsOfValues())
    {
      const Lanes most = All(this->scene.shadows.mostExtinction);
      const float weight = this->scene.parameters.partWeights[this->scene.constituent.component];
      return Min(weight * varimarch::MeanExtinctionOf(this->scene.look, start, end, most), most);
    }
    constexpr int Parts = 4;
    Lanes sum = {};
    for (int part = 0; part < Parts; ++part)
    {
      sum = sum + this->ExtinctionOf(Mix(start, end, All((float(part) + 0.5f) / Parts)), gradient);
    }
    return (1.0f / Parts) * sum;
  }

private:
  // Cuts, which few scenes have, are not inlined into the march of rays, of which there are several
  // copies.
  [[gnu::noinline]] Lanes GoToCut(Lanes t, LaneMask isAsked)
  {
    Lanes face = All(Never);
    if (this->scene.textures.maskTexture)
    {
      face = this->mask.GoTo(t, isAsked);
    }
    return this->scene.rays.croppingRegions != 0
      ? Min(face, CroppedPieces(this->scene, this->rays).NextCrossing(t))
      : face;
  }

  [[gnu::noinline]] LaneMask IsLeftByCuts(Lanes place) const
  {
    LaneMask isLeft = LaneMask(place == place);
    if (this->scene.rays.croppingRegions != 0)
    {
      isLeft &= CroppedPieces(this->scene, this->rays).IsDrawn(place);
    }
    if (this->scene.textures.maskTexture)
    {
      isLeft &= LaneMask(FloatOf(this->mask.Content()) > this->scene.parameters.leastContent);
    }
    if (const auto* const texels = this->scene.textures.gapTexture.template Texels<std::uint8_t>())
    {
      const VolumeParameters& p = this->scene.parameters;
      const PacketLattice cells(this->rays, 1.0f, -p.gapShift, glm::ivec3(p.gapCellCount));
      const IntNumbers index = cells.IndexOf(cells.At(place).cell);
      const IntLanes texel =
        IntLanesOf([&](int lane) { return std::int32_t(texels[index.of[lane]]); });
      isLeft &= (texel != GapField::NoValue) & (texel != GapField::LeftOut);
    }
    return isLeft;
  }

  [[gnu::noinline]] FLATTENED Lanes ExtinctionBy(Lanes value, const Lanes3& gradient) const
  {
    return this->material.LookOf(value, gradient).extinction;
  }

  [[gnu::noinline]] Lanes ExtinctionOfLabels(Lanes value, const Lanes3& gradient) const
  {
    return Min(this->looks.Of(this->mask.Content(), value, gradient).extinction,
      All(this->scene.shadows.mostExtinction));
  }

  const PacketScene& scene;
  const PacketRays& rays;
  PacketMaterial material;
  LabelLooks looks;
  MaskWalk mask;
  bool isCut; ///< true if cropping, a mask or gaps may take matter away
};

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
  Lanes depth;      ///< the depth of these rays with the further one, and of others as before
};

/// @param depth  up to the places
/// @param taken  the optical depth of a cell that is filled by the matter at the places
KnownDepth DepthOfCells(
  const TracedLight& light, const Lanes3& placeGrid, Lanes depth, LaneMask mask, Lanes taken);

/// The depths of rays to a light that its lattice tells.
class KnownDepths
{
public:
  /// Knows no depth, so that the rays themselves are marched.
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

/// The optical depth of boxes along rays of any origin: from face to face, so that it is exact.
class BoxDepth
{
public:
  BoxDepth(const PacketScene& scene, const PacketRays& rays, const ShadowMarch& march)
    : scene(scene)
    , boxes(scene)
    , rays(rays)
    , mostDepth(march.mostDepth)
    , walk(scene, rays, 0, 0)
    , matter(scene, rays)
    , lattice(this->boxes.LatticeOf(rays))
    , place(lattice.At(rays.enter))
    , brickEnd(rays.enter)
  {
  }

  /// See ShadowDepth.
  Lanes Along(LaneMask mask, KnownDepths known)
  {
    mask &= LaneMask(this->place.t < this->rays.exit);
    for (int index = 0; index < this->scene.rays.mostSegments && Any(mask); ++index)
    {
      const KnownDepth further = known.At(this->place.t, this->depth, mask,
        [&](LaneMask asked) { return this->ExtinctionHere(asked); });
      this->depth = further.depth;
      mask &= ~further.isKnown;
      this->SkipInvisible(mask);
      mask &= LaneMask(this->place.t < this->rays.exit);
      if (!Any(mask))
      {
        break;
      }
      this->AddBox(mask);
      mask &= LaneMask(this->place.t < this->rays.exit) & LaneMask(this->depth < this->mostDepth);
    }
    return this->depth;
  }

  /// The extinction where the rays are [1/mm].
  Lanes ExtinctionHere(LaneMask mask)
  {
    this->matter.GoTo(this->place.t, mask);
    return this->ExtinctionOfBox(mask, this->place.t);
  }

private:
  // Goes on to the next brick with anything visible.
  void SkipInvisible(LaneMask mask)
  {
    constexpr float VoxelsPerSegment = 4.0f;
    const LaneMask isAtEnd = mask & LaneMask(this->place.t >= this->brickEnd);
    if (!Any(isAtEnd))
    {
      return;
    }
    const Lanes plainMm = VoxelsPerSegment / Length(this->rays.directionGrid);
    const SegmentLanes next = this->walk.NextOfBricks(this->place.t, plainMm, isAtEnd);
    const LaneMask jumps = isAtEnd & LaneMask(next.enter > this->place.t);
    this->place = Select(jumps, this->lattice.At(next.enter), this->place);
    this->brickEnd = Select(isAtEnd, next.exit, this->brickEnd);
  }

  void AddBox(LaneMask mask)
  {
    const LatticePlace behind = this->lattice.Behind(this->place);
    const Lanes cut = Min(this->matter.GoTo(this->place.t, mask), this->rays.exit);
    const Lanes end = Min(behind.t, cut);
    const Lanes lengthMm = Max(end - this->place.t, Lanes{});
    this->depth += lengthMm * this->ExtinctionOfBox(mask, this->place.t + 0.5f * lengthMm);
    const LatticePlace inside{ this->place.cell, end };
    this->place = Select(mask, Select(LaneMask(end < behind.t), inside, behind), this->place);
  }

  // The extinction of the box in which the rays are, as far as a place in it is left.
  Lanes ExtinctionOfBox(LaneMask mask, Lanes t) const
  {
    const Lanes3& voxel = this->place.cell;
    const Lanes value = this->boxes.ValueOf(voxel);
    LaneMask absorbs = mask & MayAbsorb(this->scene.look, value, value);
    if (Any(absorbs))
    {
      absorbs &= this->matter.IsLeft(t);
    }
    if (!Any(absorbs))
    {
      return Lanes{};
    }
    const Lanes3 gradient =
      this->matter.IsOfValues() ? Lanes3(0.0f) : this->boxes.GradientOf(voxel);
    return Select(absorbs, this->matter.ExtinctionOf(value, gradient), Lanes{});
  }

  const PacketScene& scene;
  AnyBoxes boxes;
  const PacketRays& rays;
  float mostDepth;
  PacketWalk walk;
  MatterAlong matter;
  PacketLattice lattice;
  LatticePlace place;
  Lanes brickEnd; ///< the end of the segment of bricks in which the rays are
  Lanes depth = {};
};

/// The scene in whose grid rays to lights begin: that of the voxels for blocks of any level.
inline const PacketScene& SceneOfLight(const PacketScene& scene)
{
  return scene.levels.scenes ? *scene.levels.scenes[0] : scene;
}

/// A place in the grid of SceneOfLight.
inline Lanes3 PlaceOfLight(const PacketScene& scene, const Lanes3& placeGrid)
{
  return scene.levels.scenes ? PlaceIn(scene.levels.voxelGridFromOwn, placeGrid) : placeGrid;
}

template <class Voxels>
[[gnu::noinline]] FLATTENED Lanes DepthThrough(const PacketScene& scene, const PacketRays& rays,
  const ShadowMarch& march, LaneMask mask, const KnownDepths& known)
{
  return ShadowDepth<Voxels>(scene, rays, march).Along(mask, known);
}

/// The optical depth of a volume along rays. Most of the time of an image with light that matter
/// dims is spent here.
[[gnu::noinline]] FLATTENED inline Lanes DepthOfVolume(const PacketScene& scene,
  const PacketRays& rays, const ShadowMarch& march, LaneMask mask, const KnownDepths& known)
{
  if (scene.rule == PacketRule::MaterialVoxels)
  {
    return BoxDepth(scene, rays, march).Along(mask, known);
  }
  return AnyVoxels::AreOfOneType(scene)
    ? ByVoxelType(scene.volume.type,
        [&](auto voxel)
        { return DepthThrough<PacketVoxels<decltype(voxel)>>(scene, rays, march, mask, known); })
    : DepthThrough<AnyVoxels>(scene, rays, march, mask, known);
}

/// The extinction where rays begin [1/mm]; in a mixture that of interpolated voxels.
[[gnu::noinline]] inline Lanes ExtinctionAt(
  const PacketScene& scene, const PacketRays& rays, LaneMask mask)
{
  const ShadowMarch march = { 0.0f, Lanes{}, 0.0f };
  return scene.rule == PacketRule::MaterialVoxels && !scene.constituent.isOfMixture
    ? BoxDepth(scene, rays, march).ExtinctionHere(mask)
    : ShadowDepth<AnyVoxels>(scene, rays, march).ExtinctionHere(mask);
}

/// The optical depth of blocks, each by its level.
/// @param scene  that of the voxels
/// @param march  in voxels; segments in a coarser level are as much longer as its steps
[[gnu::noinline]] inline Lanes DepthOfLevels(
  const PacketScene& scene, const PacketRays& rays, const ShadowMarch& march, LaneMask mask)
{
  constexpr float GrowthPerMm = 0.3f; // NextShadowStep
  LevelPieces pieces(scene, rays);
  Lanes depth = {};
  mask &= LaneMask(rays.enter < rays.exit);
  while (Any(mask))
  {
    const PacketRays piece = pieces.Next(mask);
    for (int level = 0; level < scene.levels.count; ++level)
    {
      const PacketScene& own = *scene.levels.scenes[level];
      const PacketRays ofLevel = InGridOf(own.parameters, OfLevel(piece, level));
      const LaneMask isIn = mask & LaneMask(ofLevel.enter < ofLevel.exit);
      if (Any(isIn))
      {
        const float longestMm = march.longestMm * (own.rays.shadowStepMm / scene.rays.shadowStepMm);
        const ShadowMarch part{ longestMm,
          Min(march.firstMm + GrowthPerMm * ofLevel.enter, All(longestMm)), march.mostDepth };
        depth +=
          Select(isIn, DepthOfVolume(own, ofLevel, part, isIn, KnownDepths(ofLevel)), Lanes{});
      }
    }
    mask &= LaneMask(piece.exit < rays.exit) & LaneMask(depth < march.mostDepth);
  }
  return depth;
}

/// The optical depth along rays.
inline Lanes DepthAlong(const PacketScene& scene, const PacketRays& rays, const ShadowMarch& march,
  LaneMask mask, const KnownDepths& known)
{
  return scene.levels.scenes ? DepthOfLevels(scene, rays, march, mask)
                             : DepthOfVolume(scene, rays, march, mask, known);
}

}

}

#endif
