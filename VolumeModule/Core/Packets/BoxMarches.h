#ifndef Varimarch_Core_Packets_BoxMarches_h
#define Varimarch_Core_Packets_BoxMarches_h

// Marches from face to face of voxels without interpolation: of values, and of materials.
// Twin of March/Voxels.glsl, Loop/Cells.glsl and March/MaterialVoxels.glsl.

#include "Core/Packets/GatheredLight.h"
#include "Core/Packets/Lanes.h"
#include "Core/Packets/Looks.h"
#include "Core/Packets/Materials.h"
#include "Core/Packets/Shade.h"
#include "Core/Packets/Voxels.h"
#include "Core/Packets/Walk.h"

namespace varimarch
{

namespace
{

/// Marches from face to face: each box is read once, and its integral is exact.
/// @param take  (sum, voxel, its value, t where the rays enter it, length of the rays in it [mm], 0
///              for a ray that has ended)
template <class Boxes, class Take>
PacketSum MarchBoxes(const PacketScene& scene, const PacketRays& rays, const PacketWalk& walk,
  const PacketSum& before, const Boxes& boxes, Take take)
{
  constexpr float VoxelsPerSegment = 4.0f;
  const Lanes segmentMm = VoxelsPerSegment / Length(rays.directionGrid);
  const PacketLattice lattice = boxes.LatticeOf(rays);
  PacketSum sum = before;
  LatticePlace place = lattice.At(rays.enter);
  LaneMask going = GoOn(scene, rays, place.t, sum);
  for (int index = 0; index < scene.rays.mostSegments && Any(going); ++index)
  {
    const SegmentLanes segment = walk.NextOfBricks(place.t, segmentMm, going);
    const LaneMask jumps = going & LaneMask(segment.enter > place.t);
    place = Select(jumps, lattice.At(segment.enter), place);
    going &= LaneMask(place.t < rays.exit);
    for (LaneMask inside = going; Any(inside);
         inside &= LaneMask(place.t < segment.exit) & GoOn(scene, rays, place.t, sum))
    {
      const LatticePlace behind = lattice.Behind(place);
      const Lanes value = boxes.ValueOf(place.cell);
      const LaneMask absorbs = inside & MayAbsorb(scene.look, value, value);
      if (Any(absorbs))
      {
        const Lanes lengthMm = Select(absorbs, Min(behind.t, rays.exit) - place.t, Lanes{});
        take(sum, place.cell, value, place.t, lengthMm);
      }
      place = Select(inside, behind, place);
    }
    going &= GoOn(scene, rays, place.t, sum);
  }
  return sum;
}

template <class Boxes>
PacketSum MarchBoxValues(
  const PacketScene& scene, const PacketRays& rays, const PacketWalk& walk, const PacketSum& before)
{
  return MarchBoxes(scene, rays, walk, before, Boxes(scene),
    [&](PacketSum& sum, const Lanes3&, Lanes value, Lanes, Lanes lengthMm)
    { sum.Add(Classify(scene.look, value), lengthMm); });
}

/// A box has a single gradient, the one at its middle.
template <class Boxes, class Material>
PacketSum MarchBoxMaterials(
  const PacketScene& scene, const PacketRays& rays, const PacketWalk& walk, const PacketSum& before)
{
  const Boxes boxes(scene);
  Material material(scene, rays);
  return MarchBoxes(scene, rays, walk, before, boxes,
    [&](PacketSum& sum, const Lanes3& voxel, Lanes value, Lanes enter, Lanes lengthMm)
    {
      const Lanes3 gradient =
        material.IsPlain() ? Lanes3{ Lanes{}, Lanes{}, Lanes{} } : boxes.GradientOf(voxel);
      const Surface surface = material.SurfaceOf(gradient);
      sum.Add(material.At(value, surface, enter + 0.5f * lengthMm), lengthMm);
    });
}

/// Boxes of a material that dims its own light.
template <class Boxes, class Material>
[[gnu::noinline]] PacketSum MarchDimmedBoxes(
  const PacketScene& scene, const PacketRays& rays, const PacketWalk& walk, const PacketSum& before)
{
  const Boxes boxes(scene);
  Material material(scene, rays);
  PacketSum all = MarchBoxes(scene, rays, walk, before, boxes,
    [&](PacketSum& sum, const Lanes3& voxel, Lanes value, Lanes enter, Lanes lengthMm)
    {
      const Lanes3 gradient = boxes.GradientOf(voxel);
      const auto surface =
        SurfaceAt(material, { value, gradient }, voxel, LaneMask(lengthMm > 0.0f));
      const Lanes times = Max(All(1.0f), (1.0f / scene.rays.shadowStepMm) * lengthMm);
      const AbsorbingPieces pieces(
        Min(material.LookOf(value, gradient).extinction, All(scene.shadows.mostExtinction)),
        sum.transmittance, { enter + 0.5f * lengthMm, lengthMm }, times);
      for (int piece = 0; piece < pieces.Count(); ++piece)
      {
        AddLit(sum, material, value, surface, pieces.At(piece));
      }
    });
  AddOwed(all, material);
  return all;
}

}

}

#endif
