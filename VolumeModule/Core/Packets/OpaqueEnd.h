#ifndef Varimarch_Core_Packets_OpaqueEnd_h
#define Varimarch_Core_Packets_OpaqueEnd_h

// The places where rays meet opaque matter, which samples may miss: a ray that merely touches such
// matter has another colour than one that passes it by. In each cell the value is a cubic along the
// ray, so that no place is missed.

#include "Core/Packets/PacketScene.h"
#include "Core/Packets/Rays.h"
#include "Core/Packets/ShaderMath.h"
#include "Core/Packets/Voxels.h"
#include "Core/Packets/Walk.h"

namespace varimarch
{

namespace
{

template <class Voxels>
class OpaqueSearch
{
public:
  OpaqueSearch(const PacketScene& scene, const PacketRays& rays, const PacketWalk& walk)
    : opaque(scene.opaque)
    , rays(rays)
    , walk(walk)
    , voxels(scene)
    // The space before the first voxel and behind the last one is divided into cells too.
    , cells(rays, 1.0f, -1.0f, scene.volume.voxelCount + 1)
    , found(All(Never))
  {
  }

  /// The t of the first opaque place of each ray; Never if it has none.
  Lanes First()
  {
    const Lanes segmentMm = CellsPerSegment / Length(this->rays.directionGrid);
    LaneMask going = LaneMask(this->rays.enter < this->rays.exit);
    const LaneMask begins =
      going & this->IsOpaque(this->voxels.ValueAt(this->rays.At(this->rays.enter)));
    this->found = Select(begins, this->rays.enter, this->found);
    going &= ~begins;
    LatticePlace place = this->cells.At(this->rays.enter);
    while (Any(going))
    {
      const SegmentLanes segment = this->walk.NextOfBricks(place.t, segmentMm, going);
      const LaneMask jumps = going & LaneMask(segment.enter > place.t);
      place = Select(jumps, this->cells.At(segment.enter), place);
      going &= LaneMask(place.t < this->rays.exit);
      place = this->SearchCells(place, Min(segment.exit, this->rays.exit), going);
      going &= LaneMask(place.t < this->rays.exit) & LaneMask(this->found == Never);
    }
    return this->found;
  }

private:
  static constexpr float CellsPerSegment = 4.0f;

  LaneMask IsOpaque(Lanes value) const
  {
    LaneMask is = {};
    for (int i = 0; i < this->opaque.count; ++i)
    {
      const glm::vec2& range = this->opaque.ranges[i];
      is |= LaneMask(value >= range.x) & LaneMask(value <= range.y);
    }
    return is;
  }

  // Searches the cells of the rays of a mask, to the end of the cell that contains `end`.
  LatticePlace SearchCells(LatticePlace place, Lanes end, LaneMask mask)
  {
    while (Any(mask))
    {
      const LatticePlace behind = this->cells.Behind(place);
      const Lanes exit = Min(behind.t, this->rays.exit);
      this->SearchCell(place, exit, mask);
      place = Select(mask, behind, place);
      mask &= LaneMask(place.t < end) & LaneMask(this->found == Never);
    }
    return place;
  }

  void SearchCell(const LatticePlace& place, Lanes exit, LaneMask mask)
  {
    const Lanes4 cubic = CubicBetween(
      this->voxels.CornersOf(place.cell - 1.0f), this->rays.At(place.t), this->rays.At(exit));
    const Lanes lower = Min(Min(cubic.x, cubic.y), Min(cubic.z, cubic.w));
    const Lanes upper = Max(Max(cubic.x, cubic.y), Max(cubic.z, cubic.w));
    LaneMask holds = {};
    for (int i = 0; i < this->opaque.count; ++i)
    {
      const glm::vec2& range = this->opaque.ranges[i];
      holds |= mask & LaneMask(upper >= range.x) & LaneMask(lower <= range.y);
    }
    if (!Any(holds))
    {
      return;
    }
    const Lanes2 extremes = CubicExtremes(cubic);
    Lanes first = All(Never); // in the cell, [0, 1]
    for (const MonotonePiece& piece : { MonotonePiece{ Lanes{}, extremes.x },
           MonotonePiece{ extremes.x, extremes.y }, MonotonePiece{ extremes.y, All(1.0f) } })
    {
      first = Min(first, this->FirstIn(cubic, piece, holds));
    }
    const LaneMask meets = holds & LaneMask(first < Never);
    this->found = Select(meets, Mix(place.t, exit, first), this->found);
  }

  // The place of a piece, which does not begin in opaque matter, where it meets some.
  Lanes FirstIn(const Lanes4& cubic, const MonotonePiece& piece, LaneMask mask) const
  {
    const Lanes begin = CubicValue(cubic, piece.begin);
    const Lanes end = CubicValue(cubic, piece.end);
    Lanes first = All(Never);
    for (int i = 0; i < this->opaque.count; ++i)
    {
      const glm::vec2& range = this->opaque.ranges[i];
      const LaneMask rises = mask & LaneMask(begin < range.x) & LaneMask(end >= range.x);
      const LaneMask falls = mask & LaneMask(begin > range.y) & LaneMask(end <= range.y);
      if (Any(rises | falls))
      {
        const Lanes border = Select(rises, All(range.x), All(range.y));
        const Lanes u = CrossingOf(cubic, border, piece, rises | falls);
        first = Select(rises | falls, Min(first, u), first);
      }
    }
    return first;
  }

  const PacketOpaque& opaque;
  const PacketRays& rays;
  const PacketWalk& walk;
  Voxels voxels;
  PacketLattice cells;
  Lanes found;
};

/// The rays that end at the first opaque place of each.
template <class Voxels>
FLATTENED PacketRays EndedByOpaque(
  const PacketScene& scene, const PacketRays& rays, const PacketWalk& walk)
{
  PacketRays ended = rays;
  ended.opaqueAt = OpaqueSearch<Voxels>(scene, rays, walk).First();
  ended.exit = Min(rays.exit, ended.opaqueAt);
  return ended;
}

/// Opaque matter at the end of rays.
struct OpaquePlaces
{
  LaneMask areThere;
  Lanes t;
  Lanes3 placeGrid;
  Lanes value;    ///< opaque, as near to that of the place as the table tells apart
  Lanes lengthMm; ///< the length behind which no light is left; 0 for rays without any
};

template <class Voxels>
OpaquePlaces OpaquePlacesOf(const PacketScene& scene, const PacketRays& rays, const Voxels& voxels)
{
  OpaquePlaces places;
  places.areThere = LaneMask(rays.opaqueAt < Never);
  places.t = Select(places.areThere, rays.opaqueAt, rays.enter);
  places.placeGrid = rays.At(places.t);
  constexpr float Depth = 100.0f;
  places.lengthMm = Select(places.areThere, All(Depth / scene.shadows.mostExtinction), Lanes{});
  const Lanes found = voxels.ValueAt(places.placeGrid);
  places.value = found;
  Lanes nearest = All(Never);
  for (int i = 0; i < scene.opaque.count; ++i)
  {
    const glm::vec2& range = scene.opaque.ranges[i];
    const Lanes inside =
      Clamp(found, All(range.x + scene.opaque.entry), All(range.y - scene.opaque.entry));
    const Lanes distance = Abs(inside - found);
    places.value = Select(LaneMask(distance < nearest), inside, places.value);
    nearest = Min(nearest, distance);
  }
  return places;
}

/// A value, with its gradient if a material depends on that.
template <class Material, class Voxels>
Slope SlopeFor(const Material& material, const Voxels& voxels, const Lanes3& place, LaneMask mask)
{
  return material.IsPlain() ? Slope{ voxels.ValueAt(place), { Lanes{}, Lanes{}, Lanes{} } }
                            : voxels.SlopeAt(place, mask);
}

/// Adds the opaque matter that rays end at.
template <class Voxels, class Material>
void AddOpaqueEnd(PacketSum& sum, const PacketScene& scene, const PacketRays& rays,
  const Voxels& voxels, Material& material)
{
  if (scene.opaque.count == 0)
  {
    return;
  }
  const OpaquePlaces end = OpaquePlacesOf(scene, rays, voxels);
  if (Any(end.areThere))
  {
    const Slope slope = SlopeFor(material, voxels, end.placeGrid, end.areThere);
    AddLit(sum, material, end.value,
      SurfaceAt(material, { end.value, slope.gradient }, end.placeGrid, end.areThere),
      { end.t + 0.5f * end.lengthMm, end.lengthMm });
  }
}

}

}

#endif
