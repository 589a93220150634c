#ifndef Varimarch_Core_Packets_March_MaterialVoxels_h
#define Varimarch_Core_Packets_March_MaterialVoxels_h

// Twin of March/MaterialVoxels.glsl.

#include "Core/Packets/March/Voxels.h"
#include "Core/Packets/PacketSurface.h"

namespace varimarch
{

namespace
{

/// A box has a single gradient, the one at its middle.
template <class Voxel, class Material>
PacketSum MarchBoxMaterials(
  const PacketScene& scene, const PacketRays& rays, const PacketWalk& walk, const PacketSum& before)
{
  const PacketBoxes<Voxel> boxes(scene.volume);
  const Material material(scene, rays);
  return MarchBoxes(scene, rays, walk, before, boxes,
    [&](PacketSum& sum, const Lanes3& voxel, Lanes value, Lanes enter, Lanes lengthMm)
    {
      const Lanes3 gradient =
        material.IsPlain() ? Lanes3{ Lanes{}, Lanes{}, Lanes{} } : boxes.GradientOf(voxel);
      const Surface surface = material.SurfaceOf(gradient);
      sum.Add(material.At(value, surface, enter + 0.5f * lengthMm), lengthMm);
    });
}

}

}

#endif
