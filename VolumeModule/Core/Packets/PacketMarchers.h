#ifndef Varimarch_Core_Packets_PacketMarchers_h
#define Varimarch_Core_Packets_PacketMarchers_h

// The loops along the rays of a packet: Shaders/March/Midpoint.glsl, PreIntegrated.glsl and, for
// one component, MaterialMidpoint.glsl and MaterialSegments.glsl. Voxels are PacketVoxels or
// PacketSpline. A ray that has ended takes part in pieces of no length until all rays have ended.

#include "Core/Packets/Lanes.h"
#include "Core/Packets/PacketMaterial.h"
#include "Core/Packets/PacketOptics.h"
#include "Core/Packets/PacketRays.h"
#include "Core/Packets/PacketScene.h"
#include "Core/Packets/PacketVoxels.h"
#include "Core/Packets/PacketWalk.h"

namespace varimarch
{

namespace
{

/// The rays that go on from t.
inline LaneMask GoOn(
  const PacketScene& scene, const PacketRays& rays, Lanes t, const PacketSum& sum)
{
  return LaneMask(t < rays.exit) & LaneMask(sum.opticalDepth <= scene.steps.mostOpticalDepth);
}

/// Marches segments of equal parts, each of which a rule adds to the sum.
/// @param before  the sum in front of the rays
/// @param take    (sum, t where the segment begins, length of a part [mm], 0 for a ray that has
///                ended, mask of the rays that have jumped here from the end of the last segment)
template <int PartsPerSegment, class Take>
PacketSum MarchSegments(const PacketScene& scene, const PacketRays& rays, const PacketWalk& walk,
  const PacketSum& before, Take take)
{
  constexpr float Part = 1.0f / PartsPerSegment;
  PacketSum sum = before;
  Lanes t = rays.enter;
  LaneMask going = GoOn(scene, rays, t, sum);
  for (int index = 0; index < scene.rays.mostSegments && Any(going); ++index)
  {
    const SegmentLanes segment = walk.NextSegment(
      t, AllInt(index), PartsPerSegment * scene.rays.stepMm, sum.opticalDepth, going);
    going &= LaneMask(segment.enter < rays.exit);
    if (!Any(going))
    {
      break; // the rest is invisible
    }
    const LaneMask jumps = going & (LaneMask(segment.enter > t) | (AllInt(index) == 0));
    t = Min(segment.exit, rays.exit);
    take(sum, segment.enter, Select(going, (t - segment.enter) * Part, Lanes{}), jumps);
    going &= GoOn(scene, rays, t, sum);
  }
  return sum;
}

/// Reads the values at equal distances along rays. All cells are found before any is read, and all
/// are read before any is classified, so that no read waits for another.
/// @param placeAt  (t) -> place in the grid of the voxels
template <class Voxels, class PlaceAt, int Count>
[[gnu::flatten]] void ReadValues(
  const Voxels& voxels, PlaceAt placeAt, Lanes first, Lanes apart, Lanes (&values)[Count])
{
  typename Voxels::Cell cells[Count];
  for (int i = 0; i < Count; ++i)
  {
    cells[i] = voxels.CellOf(placeAt(first + float(i) * apart));
  }
  for (int i = 0; i < Count; ++i)
  {
    values[i] = voxels.ValueIn(cells[i]);
  }
}

template <class Voxels, int Count>
void ReadValues(
  const Voxels& voxels, const PacketRays& rays, Lanes first, Lanes apart, Lanes (&values)[Count])
{
  ReadValues(
    voxels, [&](Lanes t) { return rays.At(t); }, first, apart, values);
}

template <class Voxels>
PacketSum MarchMidpoints(
  const PacketScene& scene, const PacketRays& rays, const PacketWalk& walk, const PacketSum& before)
{
  constexpr int Parts = 4;
  const Voxels voxels(scene.volume);
  return MarchSegments<Parts>(scene, rays, walk, before,
    [&](PacketSum& sum, Lanes enter, Lanes partMm, LaneMask)
    {
      Lanes values[Parts];
      ReadValues(voxels, rays, enter + 0.5f * partMm, partMm, values);
      for (int part = 0; part < Parts; ++part)
      {
        if (Any(MayAbsorb(scene.look, values[part], values[part])))
        {
          sum.Add(Classify(scene.look, values[part]), partMm);
        }
      }
    });
}

template <class Voxels>
PacketSum MarchPreIntegrated(
  const PacketScene& scene, const PacketRays& rays, const PacketWalk& walk, const PacketSum& before)
{
  constexpr int Parts = 4;
  const Voxels voxels(scene.volume);
  Lanes start = {};
  Lanes values[Parts] = {};
  return MarchSegments<Parts>(scene, rays, walk, before,
    [&](PacketSum& sum, Lanes enter, Lanes partMm, LaneMask jumps)
    {
      start = Any(jumps) ? voxels.ValueAt(rays.At(enter)) : values[Parts - 1];
      ReadValues(voxels, rays, enter + partMm, partMm, values);
      for (const Lanes& value : values)
      {
        if (Any(MayAbsorb(scene.look, start, value)))
        {
          sum.Add(ClassifyBetween(scene.look, start, value), partMm);
        }
        start = value;
      }
    });
}

/// A value, with its gradient if a material depends on that.
template <class Material, class Voxels>
Slope SlopeFor(const Material& material, const Voxels& voxels, const Lanes3& place, LaneMask mask)
{
  return material.IsPlain() ? Slope{ voxels.ValueAt(place), { Lanes{}, Lanes{}, Lanes{} } }
                            : voxels.SlopeAt(place, mask);
}

/// Its segments have four samples, and a shader's have one: compared with a sample, finding the
/// next brick costs a packet more.
template <class Voxels, class Material>
PacketSum MarchMaterialMidpoints(
  const PacketScene& scene, const PacketRays& rays, const PacketWalk& walk, const PacketSum& before)
{
  constexpr int Parts = 4;
  const Voxels voxels(scene.volume);
  const Material material(scene, rays);
  bool isSeen = false; // the last sample: the next is then read with its gradient at once
  return MarchSegments<Parts>(scene, rays, walk, before,
    [&](PacketSum& sum, Lanes enter, Lanes partMm, LaneMask)
    {
      for (int part = 0; part < Parts; ++part)
      {
        const Lanes t = enter + (float(part) + 0.5f) * partMm;
        const Lanes3 place = rays.At(t);
        const LaneMask going = LaneMask(partMm > 0.0f);
        const auto mayAbsorb = [&](Lanes value)
        { return Any(going & MayAbsorb(scene.look, value, value)); };
        if (!isSeen && !mayAbsorb(voxels.ValueAt(place)))
        {
          continue;
        }
        const auto [value, gradient] = SlopeFor(material, voxels, place, going);
        isSeen = mayAbsorb(value);
        if (isSeen)
        {
          sum.Add(material.At(value, material.SurfaceOf(gradient), t), partMm);
        }
      }
    });
}

/// A segment along which values and surfaces are linear.
struct MaterialSegment
{
  Lanes startValue;
  Lanes endValue;
  Surface start;
  Surface end;
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
    return this->sum;
  }

private:
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
    const Surface surface = this->material.SurfaceOf(gradient);
    // Before its first visible segment a ray has no gradient yet; it absorbs least there.
    this->segment.start = Select(this->known, this->segment.end, surface);
    this->segment.end = surface;
    this->known = this->going;
  }

  /// @param along  the middle of the part, [0, 1] of the segment
  void AddPart(float along, float part)
  {
    const MaterialSegment& piece = this->segment;
    const Lanes place = All(along);
    const Optical optical = this->material.At(Mix(piece.startValue, piece.endValue, place),
      Mix(piece.start, piece.end, place), this->t - (1.0f - along) * piece.lengthMm);
    this->sum.Add(optical, part * piece.lengthMm);
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
  MaterialSegment segment = {};
};

}

}

#endif
