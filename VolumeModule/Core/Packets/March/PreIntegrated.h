#ifndef Varimarch_Core_Packets_March_PreIntegrated_h
#define Varimarch_Core_Packets_March_PreIntegrated_h

// Twin of March/PreIntegrated.glsl.

#include "Core/Packets/Classify/PreIntegrated.h"
#include "Core/Packets/Loop/Segments.h"
#include "Core/Packets/March/OpaqueEnd.h"

namespace varimarch
{

namespace
{

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

}

}

#endif
