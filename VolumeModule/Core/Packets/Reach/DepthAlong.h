#ifndef Varimarch_Core_Packets_Reach_DepthAlong_h
#define Varimarch_Core_Packets_Reach_DepthAlong_h

// The optical depth along rays of any origin, of volumes of one level or in blocks of several.

#include "Core/Packets/Levels/Blocks.h"
#include "Core/Packets/Reach/BoxShadows.h"
#include "Core/Packets/Reach/ShadowRays.h"

namespace varimarch
{

namespace
{

/// The scene in whose grid rays to lights begin: that of the voxels for blocks of any level.
inline const PacketScene& SceneOfLight(const PacketScene& scene)
{
  return scene.levels.scenes ? *scene.levels.scenes[0] : scene;
}

/// A place in the grid of SceneOfLight.
inline Lanes3 PlaceOfLight(const PacketScene& scene, const Lanes3& placeGrid)
{
  return scene.levels.scenes ? PlaceIn(scene.levels.voxelGridFromOwn, placeGrid) : placeGrid;
}

/// The optical depth of blocks, each by its level.
/// @param scene  that of the voxels
/// @param march  in voxels; segments in a coarser level are as much longer as its steps
template <class Voxels>
[[gnu::noinline]] Lanes DepthOfLevels(
  const PacketScene& scene, const PacketRays& rays, LaneMask mask, const ShadowMarch& march)
{
  constexpr float GrowthPerMm = 0.3f; // NextShadowStep
  LevelPieces pieces(scene, rays);
  Lanes depth = {};
  mask &= LaneMask(rays.enter < rays.exit);
  while (Any(mask))
  {
    const PacketRays piece = pieces.Next(mask);
    for (int level = 0; level < scene.levels.count; ++level)
    {
      const PacketScene& own = *scene.levels.scenes[level];
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
  return scene.levels.scenes ? DepthOfLevels<Voxels>(scene, rays, mask, march)
                             : ShadowDepth<Voxels>(scene, voxels, rays, march).Along(mask, known);
}

}

}

#endif
