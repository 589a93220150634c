#ifndef Varimarch_Core_Packets_Reach_ShadowRays_h
#define Varimarch_Core_Packets_Reach_ShadowRays_h

// Twin of Reach/ShadowRays.glsl.

#include "Core/Fields/GapField.h"
#include "Core/Packets/Crop/Regions.h"
#include "Core/Packets/Mask/Voxels.h"
#include "Core/Packets/Material/OneComponent.h"
#include "Core/Packets/PacketLattice.h"
#include "Core/Packets/Step/OpticalField.h"

#include <algorithm>

namespace varimarch
{

namespace
{

/// The optical depth of the volume along rays of any origin.
template <class Voxels>
class ShadowDepth
{
public:
  ShadowDepth(const PacketScene& scene, const Voxels& voxels, const PacketRays& rays)
    : scene(scene)
    , voxels(voxels)
    , rays(rays)
    , walk(scene, rays, 0, 0)
    , material(scene, rays)
    , t(rays.enter)
    , plainMm(FirstShadowStep(All(scene.rays.shadowStepMm)))
    , endValue(voxels.ValueAt(rays.At(rays.enter)))
  {
  }

  /// @param mask  the rays whose depth matters
  Lanes Along(LaneMask mask)
  {
    mask &= LaneMask(this->t < this->rays.exit);
    for (int index = 0; index < this->scene.rays.mostSegments && Any(mask); ++index)
    {
      this->AddSegment(mask);
      mask &= LaneMask(this->t < this->rays.exit) & LaneMask(this->depth < float(MostShadowDepth));
    }
    return this->depth;
  }

private:
  void AddSegment(LaneMask mask)
  {
    const SegmentLanes next = this->walk.NextOfBricks(this->t, this->plainMm, mask);
    const LaneMask jumps = LaneMask(next.enter > this->t);
    const Lanes end = Min(Select(jumps, next.enter, next.exit), this->rays.exit);
    const Lanes lengthMm = Select(jumps, Lanes{}, Max(end - next.enter, Lanes{}));
    const Lanes startValue = this->endValue;
    this->endValue = Select(mask, this->voxels.ValueAt(this->rays.At(end)), this->endValue);
    LaneMask absorbs =
      mask & LaneMask(lengthMm > 0.0f) & MayAbsorb(this->scene.look, startValue, this->endValue);
    if (Any(absorbs))
    {
      absorbs &= this->IsSeen(end - 0.5f * lengthMm);
    }
    if (Any(absorbs))
    {
      const Lanes added = lengthMm * this->MeanExtinction(startValue, end, absorbs);
      this->depth = this->depth + Select(absorbs, added, Lanes{});
    }
    this->t = Select(mask, end, this->t);
    const Lanes longer = NextShadowStep(this->plainMm, All(this->scene.rays.shadowStepMm));
    this->plainMm = Select(jumps, this->plainMm, longer);
  }

  // The rays at whose place cropping, a mask and gaps leave the volume.
  LaneMask IsSeen(Lanes place) const
  {
    LaneMask isSeen = LaneMask(place == place);
    if (this->scene.rays.croppingRegions != 0)
    {
      isSeen &= CroppedPieces(this->scene, this->rays).IsDrawn(place);
    }
    if (this->scene.textures.maskTexture)
    {
      isSeen &= MaskedPieces(this->scene, this->rays).IsDrawn(place);
    }
    if (const auto* const texels = this->scene.textures.gapTexture.template Texels<std::uint8_t>())
    {
      const VolumeParameters& p = this->scene.parameters;
      const PacketLattice cells(this->rays, 1.0f, -p.gapShift, glm::ivec3(p.gapCellCount));
      const IntNumbers index = cells.IndexOf(cells.At(place).cell);
      const IntLanes texel =
        IntLanesOf([&](int lane) { return std::int32_t(texels[index.of[lane]]); });
      isSeen &= (texel != GapField::NoValue) & (texel != GapField::LeftOut);
    }
    return isSeen;
  }

  Lanes MeanExtinction(Lanes startValue, Lanes end, LaneMask mask) const
  {
    const Lanes3 gradient =
      this->scene.textures.gradientOpacityTable || this->scene.textures.twoValueTable
      ? this->voxels.SlopeAt(this->rays.At(end), mask).gradient
      : Lanes3{ Lanes{}, Lanes{}, Lanes{} };
    constexpr int Parts = 4;
    Lanes sum = {};
    for (int part = 0; part < Parts; ++part)
    {
      const Lanes value = Mix(startValue, this->endValue, All((float(part) + 0.5f) / Parts));
      sum = sum + this->material.LookOf(value, gradient).extinction;
    }
    return (1.0f / Parts) * sum;
  }

  const PacketScene& scene;
  const Voxels& voxels;
  const PacketRays& rays;
  PacketWalk walk;
  PacketMaterial material;
  Lanes t;
  Lanes plainMm;
  Lanes endValue;
  Lanes depth = {};
};

/// The rays from points to a light, as far as the volume and its clipping planes leave them.
inline PacketRays RaysTowards(
  const PacketScene& scene, const Lanes3& originGrid, const Lanes3& directionGrid, Lanes farMm)
{
  PacketRays rays;
  rays.originGrid = originGrid;
  rays.directionGrid = directionGrid;
  rays.inverse = SafeInverse(directionGrid);
  rays.region = IntLanes{};
  rays.enter = Lanes{};
  rays.exit = farMm;
  KeepInside(rays, scene.rays.boxLowerGrid, scene.rays.boxUpperGrid);
  for (int plane = 0; plane < scene.rays.clippingPlaneCount; ++plane)
  {
    KeepBeyond(rays, scene.rayTextures.clippingPlanes[plane]);
  }
  rays.exit = Max(rays.exit, rays.enter);
  return rays;
}

/// The material of a volume whose lights cast shadows.
template <class Voxels>
class ShadowedMaterial : public PacketMaterial
{
public:
  ShadowedMaterial(const PacketScene& scene, const PacketRays& rays)
    : PacketMaterial(scene, rays)
    , voxels(scene.volume)
  {
  }

  /// Along a ray, t should ascend.
  Optical At(Lanes value, const Surface& surface, Lanes t)
  {
    Optical optical = this->LookOf(value, surface.gradient);
    this->MoveTo(t, LaneMask(optical.extinction > 0.0f));
    const Lanes along = (t - this->from) / (this->to - this->from);
    optical.color =
      this->Shaded(optical.color, surface, t, Mix(this->reachFrom, this->reachTo, along));
    return optical;
  }

private:
  // Computes the light at places on both sides of t, where it is not known. Not inlined: a
  // flattened march would contain it several times.
  [[gnu::noinline]] void MoveTo(Lanes t, LaneMask mask)
  {
    const LaneMask moves = mask & (LaneMask(t > this->to) | LaneMask(t < this->from));
    if (!Any(moves))
    {
      return;
    }
    const Lanes stepMm = All(this->scene.rays.shadowStepMm);
    const LaneMask goesOn = moves & LaneMask(t > this->to) & LaneMask(t <= this->to + stepMm);
    const LaneMask begins = moves & ~goesOn;
    this->reachFrom = Select(goesOn, this->reachTo, this->reachFrom);
    if (Any(begins))
    {
      this->reachFrom = Select(begins, this->ReachAt(t, begins), this->reachFrom);
    }
    this->from = Select(moves, Select(goesOn, this->to, t), this->from);
    this->to = Select(moves, this->from + stepMm, this->to);
    this->reachTo = Select(moves, this->ReachAt(this->to, moves), this->reachTo);
  }

  // The parts of the lights that reach places of some of the rays.
  [[gnu::noinline]] PartialLight ReachAt(Lanes t, LaneMask mask) const
  {
    const VolumeParameters& p = this->scene.parameters;
    const glm::vec4* texel = this->scene.textures.lightTexels.template Texels<glm::vec4>();
    const Lanes3 origin = this->rays.At(t);
    const Lanes3 positionWorld = this->WorldAt(t);
    PartialLight reach;
    const int count = std::min(p.distantCount + p.nearCount, PartialLight::Most);
    for (int light = 0; light < count; ++light, texel += PacketLights::TexelsPerLight)
    {
      const bool isDistant = light < p.distantCount;
      const Lanes3 toLight = isDistant ? AllOf3(*texel) : AllOf3(*texel) - positionWorld;
      const Lanes distanceMm = Max(Length(toLight), 1e-15f);
      const PacketRays towards = RaysTowards(this->scene, origin,
        Transformed(p.gridFromWorld, (1.0f / distanceMm) * toLight),
        isDistant ? All(Never) : distanceMm);
      const Lanes depth = ShadowDepth<Voxels>(this->scene, this->voxels, towards).Along(mask);
      reach.of[light] = 1.0f - Absorption(depth);
    }
    return reach;
  }

  Voxels voxels;
  Lanes from = All(-2e30f); ///< the last two places at which the light was computed
  Lanes to = All(-1e30f);
  PartialLight reachFrom;
  PartialLight reachTo;
};

}

}

#endif
