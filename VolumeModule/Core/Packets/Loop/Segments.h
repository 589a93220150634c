#ifndef Varimarch_Core_Packets_Loop_Segments_h
#define Varimarch_Core_Packets_Loop_Segments_h

// The loop along the rays of a packet. A ray that has ended takes part in pieces of no length until
// all rays have ended. Voxels are PacketVoxels or AnyVoxels.
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

/// True if rays do not contain all of a segment.
inline bool IsCut(const PacketRays& rays, Lanes enter, Lanes exit)
{
  return Any(LaneMask(enter < rays.enter) | LaneMask(exit > rays.exit));
}

/// The equal parts of a segment. A segment of the march of the whole may reach beyond the rays.
template <int Parts>
struct SegmentParts
{
  Lanes enter;           ///< the place where the segment begins
  Lanes partMm;          ///< 0 for a ray that has ended
  Lanes lengthMm[Parts]; ///< the length of each part inside the rays

  Lanes MiddleOf(int part) const { return this->enter + (float(part) + 0.5f) * this->partMm; }
};

/// @param isCut  true if the segment reaches beyond the rays
template <int Parts>
SegmentParts<Parts> PartsOf(const PacketRays& rays, Lanes enter, Lanes partMm, bool isCut)
{
  SegmentParts<Parts> parts = { enter, partMm, {} };
  for (int part = 0; part < Parts; ++part)
  {
    parts.lengthMm[part] = partMm;
  }
  if (isCut)
  {
    for (int part = 0; part < Parts; ++part)
    {
      const Lanes begin = enter + float(part) * partMm;
      parts.lengthMm[part] = rays.LengthBetween(begin, begin + partMm);
    }
  }
  return parts;
}

/// Marches segments of equal parts, each of which a rule adds to the sum.
/// @param before  the sum in front of the rays
/// @param take    (sum, parts of the segment, mask of the rays that have jumped here from the end
///                of the last segment)
template <int PartsPerSegment, class Take>
PacketSum MarchSegments(const PacketScene& scene, const PacketRays& rays, const PacketWalk& walk,
  const PacketSum& before, Take take)
{
  constexpr float Part = 1.0f / PartsPerSegment;
  const float plainMm = PartsPerSegment * scene.rays.stepMm;
  const bool areShared = scene.steps.areShared;
  const Lanes end = areShared ? rays.wholeExit : rays.exit;
  PacketSum sum = before;
  Lanes t = rays.enter;
  IntLanes index = areShared ? walk.SharedIndexAt(t, plainMm) : IntLanes{};
  LaneMask going = GoOn(scene, rays, t, sum);
  for (int count = 0; count < scene.rays.mostSegments && Any(going); ++count)
  {
    SegmentLanes segment;
    if (areShared)
    {
      const NumberedSegment numbered = walk.NextShared(index, plainMm, going);
      segment = { numbered.enter, numbered.exit };
      index = numbered.index + 1;
    }
    else
    {
      segment = walk.NextSegment(t, AllInt(count), plainMm, sum.opticalDepth, going);
    }
    going &= LaneMask(segment.enter < rays.exit);
    if (!Any(going))
    {
      break; // the rest is invisible
    }
    const LaneMask jumps = going & (LaneMask(segment.enter > t) | (AllInt(count) == 0));
    t = Min(segment.exit, end);
    const bool isCut = areShared && IsCut(rays, segment.enter, t);
    take(sum,
      PartsOf<PartsPerSegment>(
        rays, segment.enter, Select(going, (t - segment.enter) * Part, Lanes{}), isCut),
      jumps);
    going &= GoOn(scene, rays, t, sum);
  }
  return sum;
}

/// Reads the values at equal distances along rays.
template <class Voxels, int Count>
[[gnu::flatten]] void ReadValues(
  const Voxels& voxels, const PacketRays& rays, Lanes first, Lanes apart, Lanes (&values)[Count])
{
  ReadCells(
    voxels, [&](int i) { return rays.At(first + float(i) * apart); }, values);
}

}

}

#endif
