#ifndef Varimarch_Core_Packets_March_MaterialSegments_h
#define Varimarch_Core_Packets_March_MaterialSegments_h

// Twin of March/MaterialSegments.glsl.

#include "Core/Packets/Loop/Segments.h"
#include "Core/Packets/PacketSurface.h"

namespace varimarch
{

namespace
{

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
    , voxels(scene.volume)
    , material(scene, rays)
    , sum(before)
    , t(rays.enter)
  {
    this->segment.endValue = this->voxels.ValueAt(rays.At(this->t));
    this->going = GoOn(scene, rays, this->t, this->sum);
  }

  PacketSum March()
  {
    while (this->FindSegment())
    {
      this->ReadSurface();
      constexpr int Parts = 4;
      for (int part = 0; part < Parts; ++part)
      {
        this->AddPart((float(part) + 0.5f) / Parts, 1.0f / Parts);
      }
      this->going &= GoOn(this->scene, this->rays, this->t, this->sum) &
        (this->index < this->scene.rays.mostSegments);
    }
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
    const SegmentLanes next = this->walk.NextSegment(
      this->t, this->index, this->scene.rays.stepMm, this->sum.opticalDepth, mask);
    const LaneMask jumps = LaneMask(next.enter > this->t);
    const Lanes end = Min(Select(jumps, next.enter, next.exit), this->rays.exit);
    const Lanes length = Select(jumps, Lanes{}, Max(end - next.enter, Lanes{}));
    const Lanes value = this->voxels.ValueAt(this->rays.At(end));
    this->segment.startValue = Select(mask, this->segment.endValue, this->segment.startValue);
    this->segment.endValue = Select(mask, value, this->segment.endValue);
    this->segment.lengthMm = Select(mask, length, this->segment.lengthMm);
    this->t = Select(mask, end, this->t);
    this->index -= mask & ~jumps; // a mask is -1
  }

  void ReadSurface()
  {
    const Lanes3 place = this->rays.At(this->t);
    const Lanes3 gradient = this->material.IsPlain()
      ? Lanes3{ Lanes{}, Lanes{}, Lanes{} }
      : this->voxels.SlopeAt(place, this->going).gradient;
    const SurfaceType surface =
      SurfaceAt(this->material, { this->segment.endValue, gradient }, place, this->going);
    // Before its first visible segment a ray has no gradient yet; it absorbs least there.
    this->segment.start = Select(this->known, this->segment.end, surface);
    this->segment.end = surface;
    this->known = this->going;
  }

  /// @param along  the middle of the part, [0, 1] of the segment
  void AddPart(float along, float part)
  {
    const MaterialSegment<SurfaceType>& piece = this->segment;
    const Lanes place = All(along);
    AddLit(this->sum, this->material, Mix(piece.startValue, piece.endValue, place),
      Mix(piece.start, piece.end, place),
      { this->t - (1.0f - along) * piece.lengthMm, part * piece.lengthMm });
  }

  const PacketScene& scene;
  const PacketRays& rays;
  const PacketWalk& walk;
  Voxels voxels;
  Material material;
  PacketSum sum;
  Lanes t;
  IntLanes index = {};
  LaneMask going;
  LaneMask known = {}; ///< the rays whose surface at t is known
  MaterialSegment<SurfaceType> segment = {};
};

}

}

#endif
