#ifndef Varimarch_Core_Packets_March_MaterialVoxels_h
#define Varimarch_Core_Packets_March_MaterialVoxels_h

// Twin of March/MaterialVoxels.glsl.

#include "Core/Packets/Flattened.h"
#include "Core/Packets/March/Voxels.h"
#include "Core/Packets/Material/OneComponent.h"
#include "Core/Packets/PacketSurface.h"
#include "Core/Packets/Reach/AbsorbingPieces.h"

namespace varimarch
{

namespace
{

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
