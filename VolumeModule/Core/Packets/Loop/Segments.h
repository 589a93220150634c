#ifndef Varimarch_Core_Packets_Loop_Segments_h
#define Varimarch_Core_Packets_Loop_Segments_h

// The loop along the rays of a packet. A ray that has ended takes part in pieces of no length until
// all rays have ended. Voxels are PacketVoxels or PacketSpline.
// Twin of Loop/Segments.glsl.

#include "Core/Packets/Blend/Composite.h"
#include "Core/Packets/PacketRays.h"
#include "Core/Packets/Step/OpticalField.h"

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

}

}

#endif
