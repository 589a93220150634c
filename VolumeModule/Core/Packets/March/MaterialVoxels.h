#ifndef Varimarch_Core_Packets_March_MaterialVoxels_h
#define Varimarch_Core_Packets_March_MaterialVoxels_h

// Twin of March/MaterialVoxels.glsl.

#include "Core/Packets/Flattened.h"
#include "Core/Packets/March/Voxels.h"
#include "Core/Packets/Material/OneComponent.h"
#include "Core/Packets/PacketSurface.h"
#include "Core/Packets/Reach/LitPlaces.h"

#include <algorithm>

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

/// Divides the parts of rays in boxes so that the pieces absorb the same: light changes along a
/// box, and counts where it is seen.
class BoxPieces
{
public:
  /// @param transmittance  in front of the box
  /// @param longestMm      length of pieces in boxes all of which is seen
  BoxPieces(Lanes extinction, Lanes transmittance, const RayPart& inBox, float longestMm)
    : extinction(extinction)
    , enter(inBox.t - 0.5f * inBox.lengthMm)
    , lengthMm(inBox.lengthMm)
    , absorption(Absorption(Min(extinction * inBox.lengthMm, All(100.0f))))
  {
    const Lanes times = Max(All(1.0f), (1.0f / longestMm) * inBox.lengthMm);
    const Numbers wanted(float(PiecesOfWhole) * transmittance * this->absorption * times);
    for (int lane = 0; lane < LaneCount; ++lane)
    {
      const float most = std::min(wanted.of[lane], float(LitPlaces::MostPerRay));
      this->count = std::max(this->count, int(__builtin_ceilf(most)));
    }
  }

  int Count() const { return this->count; }

  /// A piece, in whose middle as much light is absorbed in front as behind.
  RayPart At(int piece) const
  {
    const float part = 1.0f / float(this->count);
    const Lanes begin = this->Along(float(piece) * part);
    const Lanes end =
      piece + 1 == this->count ? this->lengthMm : this->Along(float(piece + 1) * part);
    return { this->enter + this->Along((float(piece) + 0.5f) * part), Max(end - begin, Lanes{}) };
  }

private:
  static constexpr int PiecesOfWhole = 4;

  // The length in front of which a part of all that is absorbed is absorbed.
  Lanes Along(float part) const
  {
    constexpr float Thin = 0.01f; // light is absorbed evenly
    const LaneMask isThin = LaneMask(this->absorption < Thin);
    const Lanes depth = -Log(1.0f - part * this->absorption);
    return Select(isThin, part * this->lengthMm,
      Min(depth / Select(isThin, All(1.0f), this->extinction), this->lengthMm));
  }

  Lanes extinction;
  Lanes enter;
  Lanes lengthMm;
  Lanes absorption;
  int count = 1;
};

/// Boxes of a material that dims its own light.
template <class Voxel, class Material>
[[gnu::noinline]] PacketSum MarchDimmedBoxes(
  const PacketScene& scene, const PacketRays& rays, const PacketWalk& walk, const PacketSum& before)
{
  const PacketBoxes<Voxel> boxes(scene.volume);
  Material material(scene, rays);
  PacketSum all = MarchBoxes(scene, rays, walk, before, boxes,
    [&](PacketSum& sum, const Lanes3& voxel, Lanes value, Lanes enter, Lanes lengthMm)
    {
      const Lanes3 gradient = boxes.GradientOf(voxel);
      const auto surface =
        SurfaceAt(material, { value, gradient }, voxel, LaneMask(lengthMm > 0.0f));
      const BoxPieces pieces(material.LookOf(value, gradient).extinction, sum.transmittance,
        { enter + 0.5f * lengthMm, lengthMm }, scene.rays.shadowStepMm);
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
