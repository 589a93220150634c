#ifndef Varimarch_Core_Packets_March_Midpoint_h
#define Varimarch_Core_Packets_March_Midpoint_h

// Twin of March/Midpoint.glsl.

#include "Core/Packets/Classify/OpticalTable.h"
#include "Core/Packets/Loop/Segments.h"
#include "Core/Packets/March/OpaqueEnd.h"

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

}

}

#endif
