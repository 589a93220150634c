#ifndef Varimarch_Core_Packets_March_Voxels_h
#define Varimarch_Core_Packets_March_Voxels_h

// Voxels without interpolation: boxes of one value, which extend half a voxel to every side.
// Twin of March/Voxels.glsl and Loop/Cells.glsl.

#include "Core/Packets/Classify/OpticalTable.h"
#include "Core/Packets/Interpolation/Nearest.h"
#include "Core/Packets/Loop/Segments.h"
#include "Core/Packets/PacketLattice.h"

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

}

}

#endif
