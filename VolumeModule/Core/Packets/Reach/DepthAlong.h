#ifndef Varimarch_Core_Packets_Reach_DepthAlong_h
#define Varimarch_Core_Packets_Reach_DepthAlong_h

// The optical depth along rays of any origin, of volumes of one level or of blocks of two.

#include "Core/Packets/Levels/Blocks.h"
#include "Core/Packets/Reach/BoxShadows.h"
#include "Core/Packets/Reach/ShadowRays.h"

#include <utility>

namespace varimarch
{

namespace
{

/// The scene in whose grid rays to lights begin: that of the voxels for blocks of any level.
inline const PacketScene& SceneOfLight(const PacketScene& scene)
{
  return scene.levels.voxels ? *scene.levels.voxels : scene;
}

/// A place in the grid of SceneOfLight.
inline Lanes3 PlaceOfLight(const PacketScene& scene, const Lanes3& placeGrid)
{
  return scene.levels.voxels ? PlaceIn(scene.levels.voxelGridFromOwn, placeGrid) : placeGrid;
}

/// The optical depth of blocks, each by its level.
/// @param scene  that of the voxels
/// @param march  in voxels; segments in the coarse level are as much longer as its steps
template <class Voxels>
[[gnu::noinline]] Lanes DepthOfLevels(
  const PacketScene& scene, const PacketRays& rays, LaneMask mask, const ShadowMarch& march)
{
  const std::pair<BlockLevel, const PacketScene&> drawn[] = {
    { BlockLevel::Coarse, *scene.levels.coarse }, { BlockLevel::Voxels, scene }
  };
  constexpr float GrowthPerMm = 0.3f; // NextShadowStep
  LevelPieces pieces(scene, rays);
  Lanes depth = {};
  mask &= LaneMask(rays.enter < rays.exit);
  while (Any(mask))
  {
    const PacketRays piece = pieces.Next(mask);
    for (const auto& [level, own] : drawn)
    {
      const PacketRays ofLevel = InGridOf(own.parameters, OfLevel(piece, level));
      const LaneMask isIn = mask & LaneMask(ofLevel.enter < ofLevel.exit);
      if (Any(isIn))
      {
        const float longestMm = march.longestMm * (own.rays.shadowStepMm / scene.rays.shadowStepMm);
        const ShadowMarch part{ longestMm,
          Min(march.firstMm + GrowthPerMm * ofLevel.enter, All(longestMm)), march.mostDepth };
        const Voxels voxels(own.volume);
        depth += Select(isIn,
          ShadowDepth<Voxels>(own, voxels, ofLevel, part).Along(isIn, NothingIsKnown()), Lanes{});
      }
    }
    mask &= LaneMask(piece.exit < rays.exit) & LaneMask(depth < march.mostDepth);
  }
  return depth;
}

/// The optical depth along rays.
/// @param known  see ShadowDepth
template <class Voxels, class Known>
Lanes DepthAlong(const PacketScene& scene, const Voxels& voxels, const PacketRays& rays,
  const ShadowMarch& march, LaneMask mask, Known known)
{
  return scene.levels.coarse ? DepthOfLevels<Voxels>(scene, rays, mask, march)
                             : ShadowDepth<Voxels>(scene, voxels, rays, march).Along(mask, known);
}

}

}

#endif
