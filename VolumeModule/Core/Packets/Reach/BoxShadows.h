#ifndef Varimarch_Core_Packets_Reach_BoxShadows_h
#define Varimarch_Core_Packets_Reach_BoxShadows_h

// Rays to lights through voxels without interpolation.
// Twin of Through/Voxels.glsl.

#include "Core/Packets/Reach/ShadowRays.h"

namespace varimarch
{

namespace
{

/// The optical depth of boxes along rays of any origin: from face to face, so that it is exact.
class BoxDepth
{
public:
  BoxDepth(const PacketScene& scene, const PacketRays& rays, const ShadowMarch& march)
    : scene(scene)
    , boxes(scene)
    , rays(rays)
    , mostDepth(march.mostDepth)
    , walk(scene, rays, 0, 0)
    , matter(scene, rays)
    , lattice(this->boxes.LatticeOf(rays))
    , place(lattice.At(rays.enter))
    , brickEnd(rays.enter)
  {
  }

  /// See ShadowDepth.
  Lanes Along(LaneMask mask, KnownDepths known)
  {
    mask &= LaneMask(this->place.t < this->rays.exit);
    for (int index = 0; index < this->scene.rays.mostSegments && Any(mask); ++index)
    {
      const KnownDepth further = known.At(this->place.t, this->depth, mask,
        [&](LaneMask asked) { return this->ExtinctionHere(asked); });
      this->depth = further.depth;
      mask &= ~further.isKnown;
      this->SkipInvisible(mask);
      mask &= LaneMask(this->place.t < this->rays.exit);
      if (!Any(mask))
      {
        break;
      }
      this->AddBox(mask);
      mask &= LaneMask(this->place.t < this->rays.exit) & LaneMask(this->depth < this->mostDepth);
    }
    return this->depth;
  }

  /// The extinction where the rays are [1/mm].
  Lanes ExtinctionHere(LaneMask mask)
  {
    this->matter.GoTo(this->place.t, mask);
    return this->ExtinctionOfBox(mask, this->place.t);
  }

private:
  // Goes on to the next brick with anything visible.
  void SkipInvisible(LaneMask mask)
  {
    constexpr float VoxelsPerSegment = 4.0f;
    const LaneMask isAtEnd = mask & LaneMask(this->place.t >= this->brickEnd);
    if (!Any(isAtEnd))
    {
      return;
    }
    const Lanes plainMm = VoxelsPerSegment / Length(this->rays.directionGrid);
    const SegmentLanes next = this->walk.NextOfBricks(this->place.t, plainMm, isAtEnd);
    const LaneMask jumps = isAtEnd & LaneMask(next.enter > this->place.t);
    this->place = Select(jumps, this->lattice.At(next.enter), this->place);
    this->brickEnd = Select(isAtEnd, next.exit, this->brickEnd);
  }

  void AddBox(LaneMask mask)
  {
    const LatticePlace behind = this->lattice.Behind(this->place);
    const Lanes cut = Min(this->matter.GoTo(this->place.t, mask), this->rays.exit);
    const Lanes end = Min(behind.t, cut);
    const Lanes lengthMm = Max(end - this->place.t, Lanes{});
    this->depth += lengthMm * this->ExtinctionOfBox(mask, this->place.t + 0.5f * lengthMm);
    const LatticePlace inside{ this->place.cell, end };
    this->place = Select(mask, Select(LaneMask(end < behind.t), inside, behind), this->place);
  }

  // The extinction of the box in which the rays are, as far as a place in it is left.
  Lanes ExtinctionOfBox(LaneMask mask, Lanes t) const
  {
    const Lanes3& voxel = this->place.cell;
    const Lanes value = this->boxes.ValueOf(voxel);
    LaneMask absorbs = mask & MayAbsorb(this->scene.look, value, value);
    if (Any(absorbs))
    {
      absorbs &= this->matter.IsLeft(t);
    }
    if (!Any(absorbs))
    {
      return Lanes{};
    }
    const Lanes3 gradient =
      this->matter.IsOfValues() ? Lanes3(0.0f) : this->boxes.GradientOf(voxel);
    return Select(absorbs, this->matter.ExtinctionOf(value, gradient), Lanes{});
  }

  const PacketScene& scene;
  AnyBoxes boxes;
  const PacketRays& rays;
  float mostDepth;
  PacketWalk walk;
  MatterAlong matter;
  PacketLattice lattice;
  LatticePlace place;
  Lanes brickEnd; ///< the end of the segment of bricks in which the rays are
  Lanes depth = {};
};

}

}

#endif
