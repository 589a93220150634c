#ifndef Varimarch_Core_Packets_Reach_OpenSky_h
#define Varimarch_Core_Packets_Reach_OpenSky_h

// Light from all around, as far as matter near a place lets it through: ambient occlusion.
// Twin of Sky/OpenSky.glsl, Outside/Scalars.glsl and Outside/Labels.glsl.

#include "Core/Packets/Flattened.h"
#include "Core/Packets/Reach/DepthAlong.h"
#include "Core/Packets/Reach/LightCells.h"

namespace varimarch
{

namespace
{

/// The optical depth of a volume from places on, as far as light from all around is taken.
/// @param direction  its index in PacketSky
template <class Voxels>
FLATTENED Lanes SkyDepth(const PacketScene& scene, const Voxels& voxels, int direction,
  const Lanes3& placeGrid, LaneMask mask)
{
  PacketRays rays;
  rays.originGrid = placeGrid;
  rays.directionGrid = AllOf3(scene.sky.directions[direction]);
  rays.inverse = SafeInverse(rays.directionGrid);
  rays.region = IntLanes{};
  rays.enter = Lanes{};
  rays.exit = All(scene.sky.reachMm);
  KeepUncut(rays, scene);
  // A surface is farther from its place than the first segment.
  const float longestMm = scene.sky.stepMm;
  const ShadowMarch march = { longestMm, All(0.5f * longestMm), scene.sky.mostDepth };
  return DepthAlong(scene, voxels, rays, march, mask, NothingIsKnown());
}

/// The part of the light from all around that reaches places in a volume.
/// @tparam Voxels  with a SkyDepth
template <class Voxels>
class OpenSky
{
public:
  OpenSky(const PacketScene& scene, const Voxels& voxels)
    : scene(scene)
    , voxels(voxels)
    , cells(scene.sky.nodes, scene.sky.shape)
  {
  }

  /// @param mask  the places that matter
  Lanes At(const Lanes3& placeGrid, LaneMask mask) const
  {
    if (!this->cells)
    {
      return this->Traced(placeGrid, mask);
    }
    LaneMask agrees = mask & this->cells.Contains(placeGrid);
    const LightInCells found = this->cells.LightAt(placeGrid, agrees,
      [&](const Lanes3& nodeGrid, LaneMask nodes) { return this->Traced(nodeGrid, nodes); });
    agrees &= LaneMask(found.spread <= this->scene.sky.agreement);
    const LaneMask others = mask & ~agrees;
    return Any(others) ? Select(others, this->Traced(placeGrid, others), found.between)
                       : found.between;
  }

private:
  [[gnu::noinline]] Lanes Traced(const Lanes3& placeGrid, LaneMask mask) const
  {
    Lanes seen = {};
    for (int i = 0; i < SphereDirections; ++i)
    {
      const Lanes depth = SkyDepth(this->scene, this->voxels, i, placeGrid, mask);
      seen = seen + this->scene.sky.directions[i].w * Exp(-depth);
    }
    return KeptLight(seen, All(this->scene.sky.strength));
  }

  const PacketScene& scene;
  const Voxels& voxels;
  LightCells cells;
};

}

}

#endif
