#ifndef Varimarch_Core_Packets_Step_OpticalField_h
#define Varimarch_Core_Packets_Step_OpticalField_h

// The next part of each ray.
// Twin of Step/OpticalField.glsl, Step/Growing.glsl, Step/Fixed.glsl and Jitter/BlueNoise.glsl.

#include "Core/Packets/PacketLattice.h"
#include "Core/Packets/PacketRays.h"
#include "Core/Packets/PacketScene.h"
#include "Core/Packets/ShaderMath.h"

namespace varimarch
{

namespace
{

struct SegmentLanes
{
  Lanes enter;
  Lanes exit;
};

/// A segment with its number along its ray.
struct NumberedSegment
{
  Lanes enter;
  Lanes exit;
  IntLanes index;
};

class PacketWalk
{
public:
  /// @param x, y  the first pixel
  PacketWalk(const PacketScene& scene, const PacketRays& rays, int x, int y)
    : parameters(scene.rays)
    , steps(scene.steps)
    , rays(rays)
    , lattice(rays, scene.parameters.cellsPerBrick, 0.0f, scene.steps.brickCount)
    , firstPart(scene.rayTextures.noiseTexture ? NoiseAt(scene, x, y) : All(1.0f))
  {
  }

  /// See Shaders/Slots.glsl; only the rays of a mask matter.
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

  /// The number of the segment of the march of the whole that contains a place.
  IntLanes SharedIndexAt(Lanes t, float plainMm) const
  {
    const Lanes place = (t - this->rays.wholeEnter) * (1.0f / plainMm);
    return Truncated(Max(place + (1.0f - this->firstPart), Lanes{}));
  }

  /// The place where a segment of the march of the whole begins.
  Lanes SharedStartOf(IntLanes index, float plainMm) const
  {
    const Lanes segments = FloatOf(index) + (this->firstPart - 1.0f);
    return this->rays.wholeEnter + Max(segments, Lanes{}) * plainMm;
  }

  /// The length of a step: noise shortens the first one, and where little light is left, steps are
  /// longer.
  Lanes StepMm(IntLanes index, float plainMm, Lanes opticalDepth) const
  {
    const Lanes plain = Select(index == 0, this->firstPart * plainMm, All(plainMm));
    // A processor predicts this branch, and goes on before the depth is known.
    return Any(LaneMask(opticalDepth > DepthOfHalf)) ? Growth(opticalDepth) * plain : plain;
  }

  /// See Shaders/Step/OpticalField.glsl.
  /// @param plainMm  the length of a segment in structured bricks
  SegmentLanes NextOfBricks(Lanes t, Lanes plainMm, LaneMask mask) const
  {
    if (!this->steps.bricks)
    {
      return { t, t + plainMm };
    }
    LatticePlace place = this->lattice.At(t);
    Lanes behindT = t; // the end of bricks that are one segment
    for (int skip = 0; skip < this->parameters.mostSegments && Any(mask); ++skip)
    {
      const IntLanes content = this->ContentOf(place.cell);
      const LaneMask isOneSegment = mask & (content != 0);
      if (!Any(isOneSegment))
      {
        break; // these bricks are marched
      }
      const LatticePlace behind =
        this->lattice.BehindBlock(place, Max(FloatOf(content) - 128.0f, Lanes{}));
      behindT = Select(isOneSegment, behind.t, behindT);
      const LaneMask isInvisible = isOneSegment & (content >= 128);
      place = Select(isInvisible, behind, place);
      mask = isInvisible & LaneMask(place.t < this->rays.exit);
    }
    return { place.t, Max(place.t + plainMm, behindT) };
  }

  /// The segment of the march of the whole that has this number, or the one behind invisible
  /// bricks. Bricks that count as homogeneous are sampled too, as they belong to a part alone.
  [[gnu::noinline]] NumberedSegment NextShared(IntLanes index, float plainMm, LaneMask mask) const
  {
    if (this->steps.bricks)
    {
      const Lanes from = Max(this->SharedStartOf(index, plainMm), this->rays.enter);
      const Lanes visible = this->BehindInvisible(from, mask);
      const IntLanes behind = this->SharedIndexAt(visible, plainMm);
      index = Select(LaneMask(visible > from) & LaneMask(behind > index), behind, index);
    }
    return { this->SharedStartOf(index, plainMm), this->SharedStartOf(index + 1, plainMm), index };
  }

private:
  /// The place where rays leave the invisible bricks that begin at t.
  Lanes BehindInvisible(Lanes t, LaneMask mask) const
  {
    LatticePlace place = this->lattice.At(t);
    for (int skip = 0; skip < this->parameters.mostSegments && Any(mask); ++skip)
    {
      const IntLanes content = this->ContentOf(place.cell);
      mask &= content >= 128;
      const LatticePlace behind =
        this->lattice.BehindBlock(place, Max(FloatOf(content) - 128.0f, Lanes{}));
      place = Select(mask, behind, place);
      mask &= LaneMask(place.t < this->rays.exit);
    }
    return place.t;
  }

  static constexpr float DepthOfHalf = 0.693147181f; ///< through which half of the light passes

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
    const std::uint16_t* const texels = scene.rayTextures.noiseTexture.Texels<std::uint16_t>();
    const glm::ivec2& mask = scene.rays.noisePixelsMask;
    const auto part = [&](int lane)
    {
      const int column = (x + lane % PacketWidth) & mask.x;
      const int row = (y + lane / PacketWidth) & mask.y;
      return float(texels[row * (mask.x + 1) + column]) / 65535.0f;
    };
    return LanesOf(part);
  }

  // The bytes of the bricks, see OpticalField.
  IntLanes ContentOf(const Lanes3& brick) const
  {
    const IntNumbers index = this->lattice.IndexOf(brick);
    return IntLanesOf([&](int lane) { return std::int32_t(this->steps.bricks[index.of[lane]]); });
  }

  const RayParameters& parameters;
  const PacketSteps& steps;
  const PacketRays& rays;
  PacketLattice lattice; ///< lattice of bricks
  Lanes firstPart;       ///< the part of a segment that a ray begins with
};

}

}

#endif
