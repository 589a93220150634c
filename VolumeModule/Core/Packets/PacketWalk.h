#ifndef Varimarch_Core_Packets_PacketWalk_h
#define Varimarch_Core_Packets_PacketWalk_h

// Which part of each ray comes next: Shaders/Step/OpticalField.glsl, Growing.glsl and Fixed.glsl.

#include "Core/Packets/Lanes.h"
#include "Core/Packets/PacketRays.h"
#include "Core/Packets/PacketScene.h"

namespace varimarch
{

/// Where a ray is: a brick, and t [mm].
struct BrickPlaces
{
  Lanes3 brick; ///< whole numbers; may be beyond the volume, where a ray has left it
  Lanes t;
};

/// The walk of rays from block of bricks to block; see Shaders/Math/LatticeWalk.glsl.
class BrickLattice
{
public:
  BrickLattice(const PacketRays& rays, const PacketSteps& steps)
    : bricks(steps.bricks)
    , origin(All(1.0f / steps.cellsPerBrick) * rays.originGrid)
    , direction(All(1.0f / steps.cellsPerBrick) * rays.directionGrid)
    , inverse(All(steps.cellsPerBrick) * rays.inverse)
    , outward{ WithSignOf(All(1.0f), rays.inverse.x), WithSignOf(All(1.0f), rays.inverse.y),
      WithSignOf(All(1.0f), rays.inverse.z) }
    , fromFace(
        All(0.5f) * (this->outward + Lanes3{ All(1.0f), All(1.0f), All(1.0f) }) - this->origin)
    , last{ All(float(steps.brickCount.x - 1)), All(float(steps.brickCount.y - 1)),
      All(float(steps.brickCount.z - 1)) }
    , bricksPerRow(steps.brickCount.x)
    , bricksPerSlice(steps.brickCount.x * steps.brickCount.y)
  {
  }

  BrickPlaces At(Lanes t) const
  {
    return { this->Inside({ Floor(this->origin.x + t * this->direction.x),
               Floor(this->origin.y + t * this->direction.y),
               Floor(this->origin.z + t * this->direction.z) }),
      t };
  }

  /// What OpticalField says of the bricks.
  IntLanes ContentOf(const Lanes3& brick) const
  {
    const Lanes3 inside = this->Inside(brick);
    const IntNumbers index(Truncated(inside.x) + this->bricksPerRow * Truncated(inside.y) +
      this->bricksPerSlice * Truncated(inside.z));
    const auto content = [&](int lane) { return std::int32_t(this->bricks[index.of[lane]]); };
    return IntLanes{ content(0), content(1), content(2), content(3), content(4), content(5),
      content(6), content(7) };
  }

  /// Where rays leave the blocks of this radius around their bricks, and which brick they enter.
  BrickPlaces Behind(const BrickPlaces& place, Lanes radius) const
  {
    const Lanes3 farthest = place.brick + radius * this->outward;
    const Lanes3 exits{ (farthest.x + this->fromFace.x) * this->inverse.x,
      (farthest.y + this->fromFace.y) * this->inverse.y,
      (farthest.z + this->fromFace.z) * this->inverse.z };
    const Lanes exit = Min(Min(exits.x, exits.y), exits.z);
    const Lanes t = Max(place.t, exit);
    const auto next = [&](Lanes brick, Lanes last, Lanes outward, Lanes alongExit, Lanes position)
    {
      const Lanes within = Clamp(Floor(position), brick - radius, brick + radius);
      return Select(LaneMask(alongExit <= exit), last + outward, within);
    };
    const Lanes3 position = this->origin + t * this->direction;
    return { { next(place.brick.x, farthest.x, this->outward.x, exits.x, position.x),
               next(place.brick.y, farthest.y, this->outward.y, exits.y, position.y),
               next(place.brick.z, farthest.z, this->outward.z, exits.z, position.z) },
      t };
  }

private:
  Lanes3 Inside(const Lanes3& brick) const
  {
    return { Clamp(brick.x, Lanes{}, this->last.x), Clamp(brick.y, Lanes{}, this->last.y),
      Clamp(brick.z, Lanes{}, this->last.z) };
  }

  const std::uint8_t* bricks;
  Lanes3 origin; ///< in bricks
  Lanes3 direction;
  Lanes3 inverse;
  Lanes3 outward;  ///< 1 on axes on which rays ascend, else -1
  Lanes3 fromFace; ///< from the origin to the face of brick 0 that rays leave it through
  Lanes3 last;
  int bricksPerRow;
  int bricksPerSlice;
};

struct SegmentLanes
{
  Lanes enter;
  Lanes exit;
};

class PacketWalk
{
public:
  /// @param x  and y: of the first pixel
  PacketWalk(const PacketScene& scene, const PacketRays& rays, int x, int y)
    : steps(scene.steps)
    , rays(rays)
    , lattice(rays, scene.steps)
    , firstPart(scene.steps.noise ? NoiseAt(scene.steps, x, y) : All(1.0f))
  {
  }

  /// Shaders/Slots.glsl, of the rays of a mask.
  SegmentLanes NextSegment(
    Lanes t, IntLanes index, float plainMm, Lanes opticalDepth, LaneMask mask) const
  {
    if (!this->steps.grow)
    {
      // Positions come from the index, so that nothing accumulates over thousands of steps.
      return { t, this->rays.enter + (FloatOf(index) + this->firstPart) * plainMm };
    }
    Lanes longest = Select(index == 0, this->firstPart * plainMm, All(plainMm));
    // A processor foresees this branch, and need not wait for the depth before it goes on.
    if (Any(LaneMask(opticalDepth > DepthOfHalf)))
    {
      longest = Growth(opticalDepth) * longest;
    }
    if (!this->steps.bricks)
    {
      return { t, t + longest };
    }
    return this->NextOfBricks(t, longest, mask);
  }

private:
  static constexpr float DepthOfHalf = 0.693147181f; ///< that half of the light goes through

  // Shaders/Math/StepGrowth.glsl: sqrt(exp(depth) / 2), from 1 to 4.
  static Lanes Growth(Lanes opticalDepth)
  {
    constexpr float OctavesPerDepth = 0.5f * 1.442695041f;
    const Lanes octaves = OctavesPerDepth * (opticalDepth - DepthOfHalf);
    return SmallPowerOfTwo(Clamp(octaves, Lanes{}, All(2.0f)));
  }

  static Lanes NoiseAt(const PacketSteps& steps, int x, int y)
  {
    alignas(32) float parts[LaneCount];
    for (int lane = 0; lane < LaneCount; ++lane)
    {
      const int column = (x + lane % PacketWidth) & steps.noiseMask;
      const int row = (y + lane / PacketWidth) & steps.noiseMask;
      parts[lane] = float(steps.noise[row * (steps.noiseMask + 1) + column]) / 65535.0f;
    }
    return Lanes(_mm256_load_ps(parts));
  }

  SegmentLanes NextOfBricks(Lanes t, Lanes plainMm, LaneMask mask) const
  {
    BrickPlaces place = this->lattice.At(t);
    Lanes behindT = t; // of what is one segment
    for (int skip = 0; skip < this->steps.mostSegments && Any(mask); ++skip)
    {
      const IntLanes content = this->lattice.ContentOf(place.brick);
      const LaneMask isOneSegment = mask & (content != 0);
      if (!Any(isOneSegment))
      {
        break; // what is here is marched
      }
      const BrickPlaces behind =
        this->lattice.Behind(place, Max(FloatOf(content) - 128.0f, Lanes{}));
      behindT = Select(isOneSegment, behind.t, behindT);
      const LaneMask isInvisible = isOneSegment & (content >= 128);
      place.t = Select(isInvisible, behind.t, place.t);
      place.brick = { Select(isInvisible, behind.brick.x, place.brick.x),
        Select(isInvisible, behind.brick.y, place.brick.y),
        Select(isInvisible, behind.brick.z, place.brick.z) };
      mask = isInvisible & LaneMask(place.t < this->rays.exit);
    }
    return { place.t, Max(place.t + plainMm, behindT) };
  }

  const PacketSteps& steps;
  const PacketRays& rays;
  BrickLattice lattice;
  Lanes firstPart; ///< of a segment, with which a ray begins
};

}

#endif
