#ifndef Varimarch_Core_Packets_PacketWalk_h
#define Varimarch_Core_Packets_PacketWalk_h

// Which part of each ray comes next: Shaders/Step/OpticalField.glsl, Growing.glsl and Fixed.glsl.

#include "Core/Packets/Lanes.h"
#include "Core/Packets/PacketLattice.h"
#include "Core/Packets/PacketRays.h"
#include "Core/Packets/PacketScene.h"

namespace varimarch
{

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
    : parameters(scene.rays)
    , steps(scene.steps)
    , rays(rays)
    , lattice(rays, scene.parameters.cellsPerBrick, 0.0f, scene.steps.brickCount)
    , firstPart(scene.steps.noise ? NoiseAt(scene, x, y) : All(1.0f))
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
    return this->NextOfBricks(t, this->StepMm(index, plainMm, opticalDepth), mask);
  }

  /// Of the sample distance: noise shortens the first, and behind what is nearly opaque it is
  /// longer.
  Lanes StepMm(IntLanes index, float plainMm, Lanes opticalDepth) const
  {
    const Lanes plain = Select(index == 0, this->firstPart * plainMm, All(plainMm));
    // A processor foresees this branch, and need not wait for the depth before it goes on.
    return Any(LaneMask(opticalDepth > DepthOfHalf)) ? Growth(opticalDepth) * plain : plain;
  }

  /// Of parts as long as they are marched where bricks are structured.
  SegmentLanes NextOfBricks(Lanes t, Lanes plainMm, LaneMask mask) const
  {
    if (!this->steps.bricks)
    {
      return { t, t + plainMm };
    }
    LatticePlaces place = this->lattice.At(t);
    Lanes behindT = t; // of what is one segment
    for (int skip = 0; skip < this->parameters.mostSegments && Any(mask); ++skip)
    {
      const IntLanes content = this->ContentOf(place.cell);
      const LaneMask isOneSegment = mask & (content != 0);
      if (!Any(isOneSegment))
      {
        break; // what is here is marched
      }
      const LatticePlaces behind =
        this->lattice.BehindBlock(place, Max(FloatOf(content) - 128.0f, Lanes{}));
      behindT = Select(isOneSegment, behind.t, behindT);
      const LaneMask isInvisible = isOneSegment & (content >= 128);
      place = Select(isInvisible, behind, place);
      mask = isInvisible & LaneMask(place.t < this->rays.exit);
    }
    return { place.t, Max(place.t + plainMm, behindT) };
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

  // Shaders/Jitter/BlueNoise.glsl.
  static Lanes NoiseAt(const PacketScene& scene, int x, int y)
  {
    const glm::ivec2& mask = scene.rays.noisePixelsMask;
    alignas(32) float parts[LaneCount];
    for (int lane = 0; lane < LaneCount; ++lane)
    {
      const int column = (x + lane % PacketWidth) & mask.x;
      const int row = (y + lane / PacketWidth) & mask.y;
      parts[lane] = float(scene.steps.noise[row * (mask.x + 1) + column]) / 65535.0f;
    }
    return Lanes(_mm256_load_ps(parts));
  }

  // What OpticalField says of the bricks.
  IntLanes ContentOf(const Lanes3& brick) const
  {
    const IntNumbers index = this->lattice.IndexOf(brick);
    const auto content = [&](int lane) { return std::int32_t(this->steps.bricks[index.of[lane]]); };
    return IntLanes{ content(0), content(1), content(2), content(3), content(4), content(5),
      content(6), content(7) };
  }

  const RayParameters& parameters;
  const PacketSteps& steps;
  const PacketRays& rays;
  PacketLattice lattice; ///< of bricks
  Lanes firstPart;       ///< of a segment, with which a ray begins
};

}

#endif
