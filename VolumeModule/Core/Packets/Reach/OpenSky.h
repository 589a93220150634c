#ifndef Varimarch_Core_Packets_Reach_OpenSky_h
#define Varimarch_Core_Packets_Reach_OpenSky_h

// Light from all around, as far as matter near a place lets it through: ambient occlusion.
// Twin of Sky/OpenSky.glsl, Outside/Scalars.glsl and Outside/Labels.glsl.

#include "Core/Packets/Reach/DepthAlong.h"
#include "Core/Packets/Reach/LightCells.h"

namespace varimarch
{

namespace
{

/// All constituents of a mixture; a volume that is no mixture is the only one.
class AllConstituents
{
public:
  explicit AllConstituents(const PacketScene& first)
    : first(first)
  {
  }

  int Count() const { return this->first.constituent.otherCount + 1; }

  const PacketScene& operator[](int index) const
  {
    return index == 0 ? this->first : this->first.constituent.others[index - 1];
  }

private:
  const PacketScene& first;
};

/// Places in the grid of a volume, for places in that of another one.
inline Lanes3 PlaceInGridOf(
  const VolumeParameters& volume, const VolumeParameters& other, const Lanes3& placeGrid)
{
  const Lanes3 world =
    Transformed(other.worldFromGrid, placeGrid) + AllOf3(other.worldOfGridOrigin);
  return Transformed(volume.gridFromWorld, world - AllOf3(volume.worldOfGridOrigin));
}

/// The optical depth of a volume from places on, as far as light from all around is taken.
/// @param direction  its index in PacketSky
/// @param isOfNodes  true for the places of nodes of the lattice
inline Lanes OwnSkyDepth(
  const PacketScene& scene, int direction, const Lanes3& placeGrid, LaneMask mask, bool isOfNodes)
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
  const float longestMm = isOfNodes ? scene.sky.nodeStepMm : scene.sky.stepMm;
  const ShadowMarch march = { longestMm, All(0.5f * longestMm), scene.sky.mostDepth };
  return DepthAlong(scene, rays, march, mask, KnownDepths(rays));
}

/// The optical depth of all constituents from places on, in the grid of one of them.
inline Lanes SkyDepth(const PacketScene& scene, const AllConstituents& all, int direction,
  const Lanes3& placeGrid, LaneMask mask, bool isOfNodes)
{
  if (!scene.constituent.isOfMixture)
  {
    return OwnSkyDepth(scene, direction, placeGrid, mask, isOfNodes);
  }
  Lanes depth = {};
  for (int i = 0; i < all.Count(); ++i)
  {
    const LaneMask counts = mask & LaneMask(depth < scene.sky.mostDepth);
    if (!Any(counts))
    {
      break;
    }
    const PacketScene& other = all[i];
    const Lanes own = OwnSkyDepth(other, direction,
      PlaceInGridOf(other.parameters, scene.parameters, placeGrid), counts, isOfNodes);
    depth = depth + Select(counts, own, Lanes{});
  }
  return depth;
}

/// The part of the light from all around that reaches places in a volume. Where it is traced,
/// places that follow each other at less than half of a segment are extrapolated from those before.
class OpenSky
{
public:
  /// @param scene  the one with the places
  /// @param first  the first constituent of its mixture, or itself
  OpenSky(const PacketScene& scene, const PacketScene& first)
    : scene(scene)
    , all(first)
    , cells(scene.sky.nodes, scene.sky.shape)
  {
  }

  /// @param mask  the places that matter
  [[gnu::noinline]] Lanes At(const Lanes3& placeGrid, LaneMask mask)
  {
    if (!this->cells)
    {
      return this->Followed(placeGrid, mask);
    }
    LaneMask agrees = mask & this->cells.Contains(placeGrid);
    const LightInCells found = this->cells.LightAt(placeGrid, agrees,
      [&](const Lanes3& nodeGrid, LaneMask nodes) { return this->Traced(nodeGrid, nodes, true); });
    agrees &= LaneMask(found.spread <= this->scene.sky.agreement);
    const LaneMask others = mask & ~agrees;
    return Any(others) ? Select(others, this->Followed(placeGrid, others), found.between)
                       : found.between;
  }

private:
  // A packet is traced for all of its places if one of them asks for it.
  Lanes Followed(const Lanes3& placeGrid, LaneMask mask)
  {
    const Lanes movedMm =
      Length(Transformed(this->scene.parameters.worldFromGrid, placeGrid - this->lastGrid));
    // The light of boxes of voxels jumps.
    const bool isOfBoxes = this->scene.rule == PacketRule::MaterialVoxels;
    const float longestMm = isOfBoxes ? 0.0f : 0.5f * this->scene.sky.stepMm;
    const LaneMask follows = this->isKnown & LaneMask(movedMm <= longestMm);
    if (!Any(mask & ~follows))
    {
      return Clamp(this->lastOpen + movedMm * this->changePerMm, 0.0f, 1.0f);
    }
    const Lanes open = this->Traced(placeGrid, mask, false);
    const LaneMask goesOn = mask & this->isKnown & LaneMask(movedMm < 2.0f * longestMm);
    this->changePerMm =
      Select(goesOn, (open - this->lastOpen) / Max(movedMm, All(1e-6f * longestMm)), Lanes{});
    this->lastOpen = open;
    this->lastGrid = placeGrid;
    this->isKnown = mask;
    return open;
  }

  [[gnu::noinline]] Lanes Traced(const Lanes3& placeGrid, LaneMask mask, bool isOfNodes) const
  {
    Lanes seen = {};
    for (int i = 0; i < SphereDirections; ++i)
    {
      const Lanes depth = SkyDepth(this->scene, this->all, i, placeGrid, mask, isOfNodes);
      seen = seen + this->scene.sky.directions[i].w * Exp(-depth);
    }
    return KeptLight(seen, All(this->scene.sky.strength));
  }

  const PacketScene& scene;
  AllConstituents all;
  LightCells cells;
  Lanes3 lastGrid = Lanes3(0.0f); ///< the places that were traced last
  Lanes lastOpen = {};
  Lanes changePerMm = {}; ///< change of the light when these places were reached
  LaneMask isKnown = {};  ///< the rays that had such places
};

}

}

#endif
