#ifndef Varimarch_Core_Packets_March_MaterialMidpoint_h
#define Varimarch_Core_Packets_March_MaterialMidpoint_h

// Twin of March/MaterialMidpoint.glsl.

#include "Core/Packets/Interpolation/Linear.h"
#include "Core/Packets/Loop/Segments.h"
#include "Core/Packets/March/OpaqueEnd.h"

namespace varimarch
{

namespace
{

/// Its segments have four samples, and a shader's have one: compared with a sample, finding the
/// next brick costs a packet more.
template <class Voxels, class Material>
PacketSum MarchMaterialMidpoints(
  const PacketScene& scene, const PacketRays& rays, const PacketWalk& walk, const PacketSum& before)
{
  constexpr int Parts = 4;
  const Voxels voxels(scene);
  Material material(scene, rays);
  bool isSeen = false; // the last sample: the next is then read with its gradient at once
  PacketSum all = MarchSegments<Parts>(scene, rays, walk, before,
    [&](PacketSum& sum, const SegmentParts<Parts>& parts, LaneMask)
    {
      for (int part = 0; part < Parts; ++part)
      {
        const Lanes t = parts.MiddleOf(part);
        const Lanes3 place = rays.At(t);
        const LaneMask going = LaneMask(parts.lengthMm[part] > 0.0f);
        const auto absorbing = [&](Lanes value)
        { return going & MayAbsorb(scene.look, value, value); };
        if (!isSeen && !Any(absorbing(voxels.ValueAt(place))))
        {
          continue;
        }
        const auto [value, gradient] = SlopeFor(material, voxels, place, going);
        const LaneMask absorbs = absorbing(value);
        isSeen = Any(absorbs);
        if (isSeen)
        {
          AddLit(sum, material, value, SurfaceAt(material, { value, gradient }, place, absorbs),
            { t, parts.lengthMm[part] });
        }
      }
    });
  AddOpaqueEnd(all, scene, rays, voxels, material);
  AddOwed(all, material);
  return all;
}

}

}

#endif
