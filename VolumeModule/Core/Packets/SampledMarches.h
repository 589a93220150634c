#ifndef Varimarch_Core_Packets_SampledMarches_h
#define Varimarch_Core_Packets_SampledMarches_h

// Marches by samples: of values, and of materials.
// Twin of March/Midpoint.glsl, March/PreIntegrated.glsl, March/MaterialMidpoint.glsl and
// March/MaterialSegments.glsl.

#include "Core/Packets/Lanes.h"
#include "Core/Packets/Looks.h"
#include "Core/Packets/OpaqueEnd.h"
#include "Core/Packets/Shade.h"
#include "Core/Packets/Voxels.h"
#include "Core/Packets/Walk.h"

namespace varimarch
{

namespace
{

template <class Voxels>
PacketSum MarchMidpoints(
  const PacketScene& scene, const PacketRays& rays, const PacketWalk& walk, const PacketSum& before)
{
  constexpr int Parts = 4;
  const Voxels voxels(scene);
  PacketSum all = MarchSegments<Parts>(scene, rays, walk, before,
    [&](PacketSum& sum, const SegmentParts<Parts>& parts, LaneMask)
    {
      Lanes values[Parts];
      ReadValues(voxels, rays, parts.enter + 0.5f * parts.partMm, parts.partMm, values);
      for (int part = 0; part < Parts; ++part)
      {
        if (Any(MayAbsorb(scene.look, values[part], values[part])))
        {
          sum.Add(Classify(scene.look, values[part]), parts.lengthMm[part]);
        }
      }
    });
  if (scene.opaque.count > 0)
  {
    const OpaquePlaces end = OpaquePlacesOf(scene, rays, voxels);
    all.Add(Classify(scene.look, end.value), end.lengthMm);
  }
  return all;
}

template <class Voxels>
PacketSum MarchPreIntegrated(
  const PacketScene& scene, const PacketRays& rays, const PacketWalk& walk, const PacketSum& before)
{
  constexpr int Parts = 4;
  const Voxels voxels(scene);
  Lanes start = {};
  Lanes values[Parts] = {};
  PacketSum all = MarchSegments<Parts>(scene, rays, walk, before,
    [&](PacketSum& sum, const SegmentParts<Parts>& parts, LaneMask jumps)
    {
      start = Any(jumps) ? voxels.ValueAt(rays.At(parts.enter)) : values[Parts - 1];
      ReadValues(voxels, rays, parts.enter + parts.partMm, parts.partMm, values);
      for (int part = 0; part < Parts; ++part)
      {
        const Lanes value = values[part];
        if (Any(MayAbsorb(scene.look, start, value)))
        {
          sum.Add(ClassifyBetween(scene.look, start, value), parts.lengthMm[part]);
        }
        start = value;
      }
    });
  if (scene.opaque.count > 0)
  {
    const OpaquePlaces end = OpaquePlacesOf(scene, rays, voxels);
    all.Add(ClassifyBetween(scene.look, end.value, end.value), end.lengthMm);
  }
  return all;
}

/// Its segments have four samples, and a shader's have one: compared with a sample, finding the
/// next brick costs a packet more.
template <class Voxels, class Material>
PacketSum MarchMaterialMidpoints(
  const PacketScene& scene, const PacketRays& rays, const PacketWalk& walk, const PacketSum& before)
{
  constexpr int Parts = 4;
  const Voxels voxels(scene);
  Material material(scene, rays);
  bool isSeen = false; // the last sample: the next is then read with its gradient at once
  PacketSum all = MarchSegments<Parts>(scene, rays, walk, before,
    [&](PacketSum& sum, const SegmentParts<Parts>& parts, LaneMask)
    {
      for (int part = 0; part < Parts; ++part)
      {
        const Lanes t = parts.MiddleOf(part);
        const Lanes3 place = rays.At(t);
        const LaneMask going = LaneMask(parts.lengthMm[part] > 0.0f);
        const auto absorbing = [&](Lanes value)
        { return going & MayAbsorb(scene.look, value, value); };
        if (!isSeen && !Any(absorbing(voxels.ValueAt(place))))
        {
          continue;
        }
        const auto [value, gradient] = SlopeFor(material, voxels, place, going);
        const LaneMask absorbs = absorbing(value);
        isSeen = Any(absorbs);
        if (isSeen)
        {
          AddLit(sum, material, value, SurfaceAt(material, { value, gradient }, place, absorbs),
            { t, parts.lengthMm[part] });
        }
      }
    });
  AddOpaqueEnd(all, scene, rays, voxels, material);
  AddOwed(all, material);
  return all;
}

/// A segment along which values and surfaces are linear.
template <class SurfaceType>
struct MaterialSegment
{
  Lanes startValue;
  Lanes endValue;
  SurfaceType start;
  SurfaceType end;
  Lanes lengthMm;
};

/// A march through a material, from each segment that absorbs anything to the next one.
template <class Voxels, class Material>
class MaterialMarch
{
public:
  MaterialMarch(const PacketScene& scene, const PacketRays& rays, const PacketWalk& walk,
    const PacketSum& before)
    : scene(scene)
    , rays(rays)
    , walk(walk)
    , voxels(scene)
    , material(scene, rays)
    , sum(before)
    , t(rays.enter)
    , end(rays.exit)
  {
    if (scene.steps.areShared)
    {
      this->index = walk.SharedIndexAt(rays.enter, scene.rays.stepMm);
      this->t = walk.SharedStartOf(this->index, scene.rays.stepMm);
      this->end = rays.wholeExit;
    }
    this->segment.endValue = this->voxels.ValueAt(rays.At(this->t));
    this->going = GoOn(scene, rays, this->t, this->sum);
  }

  PacketSum March()
  {
    while (this->FindSegment())
    {
      this->ReadSurface();
      this->isCut =
        this->scene.steps.areShared && IsCut(this->rays, this->t - this->segment.lengthMm, this->t);
      constexpr int Parts = 4;
      for (int part = 0; part < Parts; ++part)
      {
        this->AddPart((float(part) + 0.5f) / Parts, 1.0f / Parts);
      }
      this->going &= GoOn(this->scene, this->rays, this->t, this->sum) &
        (this->index < this->scene.rays.mostSegments);
    }
    AddOpaqueEnd(this->sum, this->scene, this->rays, this->voxels, this->material);
    AddOwed(this->sum, this->material);
    return this->sum;
  }

private:
  using SurfaceType = typename Material::SurfaceType;

  /// Advances to the next segment that absorbs; false if no ray has one.
  bool FindSegment()
  {
    LaneMask searching = this->going;
    this->going = LaneMask{};
    this->segment.lengthMm = Lanes{};
    while (Any(searching))
    {
      this->NextSegment(searching);
      const LaneMask absorbs = searching & LaneMask(this->segment.lengthMm > 0.0f) &
        MayAbsorb(this->scene.look, this->segment.startValue, this->segment.endValue);
      this->going |= absorbs;
      searching &= ~absorbs;
      this->known &= ~searching;
      searching &=
        LaneMask(this->t < this->rays.exit) & (this->index < this->scene.rays.mostSegments);
    }
    this->segment.lengthMm = Select(this->going, this->segment.lengthMm, Lanes{});
    return Any(this->going);
  }

  // Advances the rays of a mask. A ray that jumps gets a segment without length, which reads the
  // value behind the jump.
  void NextSegment(LaneMask mask)
  {
    SegmentLanes next;
    if (this->scene.steps.areShared)
    {
      const NumberedSegment numbered =
        this->walk.NextShared(this->index, this->scene.rays.stepMm, mask);
      next = { numbered.enter, numbered.exit };
      this->index = Select(mask, numbered.index, this->index);
    }
    else
    {
      next = this->walk.NextSegment(
        this->t, this->index, this->scene.rays.stepMm, this->sum.opticalDepth, mask);
    }
    const LaneMask jumps = LaneMask(next.enter > this->t);
    const Lanes newT = Min(Select(jumps, next.enter, next.exit), this->end);
    const Lanes length = Select(jumps, Lanes{}, Max(newT - next.enter, Lanes{}));
    const Lanes value = this->voxels.ValueAt(this->rays.At(newT));
    this->segment.startValue = Select(mask, this->segment.endValue, this->segment.startValue);
    this->segment.endValue = Select(mask, value, this->segment.endValue);
    this->segment.lengthMm = Select(mask, length, this->segment.lengthMm);
    this->t = Select(mask, newT, this->t);
    this->index -= mask & ~jumps; // a mask is -1
  }

  void ReadSurface()
  {
    const SurfaceType surface = SurfaceOn(
      this->voxels, this->material, this->rays.At(this->t), this->segment.endValue, this->going);
    // Before its first visible segment a ray has no gradient yet; it absorbs least there. A part
    // cannot know whether it is the first segment of the whole.
    const bool readsStart = this->scene.steps.areShared && Any(this->going & ~this->known);
    const SurfaceType unknown = readsStart
      ? SurfaceAtStart(this->scene, this->rays, this->t - this->segment.lengthMm,
          this->segment.startValue, this->going)
      : surface;
    this->segment.start = Select(this->known, this->segment.end, unknown);
    this->segment.end = surface;
    this->known = this->going;
  }

  static SurfaceType SurfaceOn(
    const Voxels& voxels, Material& material, const Lanes3& place, Lanes value, LaneMask going)
  {
    const Lanes3 gradient = material.IsPlain() ? Lanes3{ Lanes{}, Lanes{}, Lanes{} }
                                               : voxels.SlopeAt(place, going).gradient;
    return SurfaceAt(material, { value, gradient }, place, going);
  }

  /// Takes nothing of the march by its address, so that the march stays in registers.
  [[gnu::noinline]] FLATTENED static SurfaceType SurfaceAtStart(
    const PacketScene& scene, const PacketRays& rays, Lanes t, Lanes value, LaneMask going)
  {
    Material material(scene, rays);
    return SurfaceOn(Voxels(scene), material, rays.At(t), value, going);
  }

  /// @param along  the middle of the part, [0, 1] of the segment
  void AddPart(float along, float part)
  {
    const MaterialSegment<SurfaceType>& piece = this->segment;
    const Lanes place = All(along);
    const Lanes middle = this->t - (1.0f - along) * piece.lengthMm;
    const Lanes partMm = part * piece.lengthMm;
    AddLit(this->sum, this->material, Mix(piece.startValue, piece.endValue, place),
      Mix(piece.start, piece.end, place),
      { middle,
        this->isCut ? this->rays.LengthBetween(middle - 0.5f * partMm, middle + 0.5f * partMm)
                    : partMm });
  }

  const PacketScene& scene;
  const PacketRays& rays;
  const PacketWalk& walk;
  Voxels voxels;
  Material material;
  PacketSum sum;
  Lanes t;
  Lanes end;          ///< the end of the last segment
  bool isCut = false; ///< true if the segment reaches beyond the rays
  IntLanes index = {};
  LaneMask going;
  LaneMask known = {}; ///< the rays whose surface at t is known
  MaterialSegment<SurfaceType> segment = {};
};

}

}

#endif
