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

template <class Voxels>
[[gnu::noinline]] FLATTENED Lanes DepthThrough(const PacketScene& scene, const PacketRays& rays,
  const ShadowMarch& march, LaneMask mask, const KnownDepths& known)
{
  return ShadowDepth<Voxels>(scene, rays, march).Along(mask, known);
}

/// The optical depth of a volume along rays. Most of the time of an image with light that matter
/// dims is spent here.
[[gnu::noinline]] FLATTENED inline Lanes DepthOfVolume(const PacketScene& scene,
  const PacketRays& rays, const ShadowMarch& march, LaneMask mask, const KnownDepths& known)
{
  if (scene.rule == PacketRule::MaterialVoxels)
  {
    return BoxDepth(scene, rays, march).Along(mask, known);
  }
  return AnyVoxels::AreOfOneType(scene)
    ? ByVoxelType(scene.volume.type,
        [&](auto voxel)
        { return DepthThrough<PacketVoxels<decltype(voxel)>>(scene, rays, march, mask, known); })
    : DepthThrough<AnyVoxels>(scene, rays, march, mask, known);
}

/// The extinction where rays begin [1/mm]; in a mixture that of interpolated voxels.
[[gnu::noinline]] inline Lanes ExtinctionAt(
  const PacketScene& scene, const PacketRays& rays, LaneMask mask)
{
  const ShadowMarch march = { 0.0f, Lanes{}, 0.0f };
  return scene.rule == PacketRule::MaterialVoxels && !scene.constituent.isOfMixture
    ? BoxDepth(scene, rays, march).ExtinctionHere(mask)
    : ShadowDepth<AnyVoxels>(scene, rays, march).ExtinctionHere(mask);
}

/// The optical depth of blocks, each by its level.
/// @param scene  that of the voxels
/// @param march  in voxels; segments in a coarser level are as much longer as its steps
[[gnu::noinline]] inline Lanes DepthOfLevels(
  const PacketScene& scene, const PacketRays& rays, const ShadowMarch& march, LaneMask mask)
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
        depth +=
          Select(isIn, DepthOfVolume(own, ofLevel, part, isIn, KnownDepths(ofLevel)), Lanes{});
      }
    }
    mask &= LaneMask(piece.exit < rays.exit) & LaneMask(depth < march.mostDepth);
  }
  return depth;
}

/// The optical depth along rays.
inline Lanes DepthAlong(const PacketScene& scene, const PacketRays& rays, const ShadowMarch& march,
  LaneMask mask, const KnownDepths& known)
{
  return scene.levels.scenes ? DepthOfLevels(scene, rays, march, mask)
                             : DepthOfVolume(scene, rays, march, mask, known);
}

}

}

#endif
