#ifndef Varimarch_Core_Packets_March_PreIntegrated_h
#define Varimarch_Core_Packets_March_PreIntegrated_h

// Twin of March/PreIntegrated.glsl.

#include "Core/Packets/Classify/PreIntegrated.h"
#include "Core/Packets/Loop/Segments.h"

namespace varimarch
{

namespace
{

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

}

}

#endif
