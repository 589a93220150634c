#ifndef Varimarch_Core_Packets_Walk_h
#define Varimarch_Core_Packets_Walk_h

// The way along the rays of a packet: through the cells of a lattice, from one segment to the next,
// and the sum of what they meet. A ray that has ended takes part in pieces of no length until all
// rays have ended.
// Twin of Step/OpticalField.glsl, Step/Growing.glsl, Step/Fixed.glsl, Jitter/BlueNoise.glsl,
// Blend/Composite.glsl and Loop/Segments.glsl.

#include "Core/Packets/Looks.h"
#include "Core/Packets/PacketScene.h"
#include "Core/Packets/Rays.h"
#include "Core/Packets/ShaderMath.h"

namespace varimarch
{

namespace
{

inline LatticePlace Select(LaneMask mask, const LatticePlace& yes, const LatticePlace& no)
{
  return { Select(mask, yes.cell, no.cell), Select(mask, yes.t, no.t) };
}

class PacketLattice
{
public:
  /// @param cellSideGrid   length of a cell's side, in voxels
  /// @param firstCellGrid  where cell 0 begins, on each axis
  PacketLattice(
    const PacketRays& rays, float cellSideGrid, float firstCellGrid, const glm::ivec3& cellCount)
    : ray(RayInLattice((1.0f / cellSideGrid) * (rays.originGrid - firstCellGrid),
        (1.0f / cellSideGrid) * rays.directionGrid))
    , count(AllOf3(glm::vec3(cellCount)))
    , cellsPerRow(cellCount.x)
    , cellsPerSlice(cellCount.x * cellCount.y)
  {
  }

  LatticePlace At(Lanes t) const { return PlaceAt(this->ray, t, this->count); }

  /// The indices of cells in memory; outside the lattice, that of the nearest cell.
  IntNumbers IndexOf(const Lanes3& cell) const
  {
    const Lanes3 inside = Clamp(cell, Lanes3(0.0f), this->count - 1.0f);
    return IntNumbers(Truncated(inside.x) + this->cellsPerRow * Truncated(inside.y) +
      this->cellsPerSlice * Truncated(inside.z));
  }

  /// The places where rays leave their cells, with the cells that they enter. These may be beyond
  /// the lattice.
  LatticePlace Behind(const LatticePlace& place) const { return BehindCell(this->ray, place); }

  /// The same for blocks of this radius around the cells.
  LatticePlace BehindBlock(const LatticePlace& place, Lanes radius) const
  {
    return varimarch::BehindBlock(this->ray, place, radius);
  }

private:
  LatticeRay ray;
  Lanes3 count;
  int cellsPerRow;
  int cellsPerSlice;
};

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

/// The emission and absorption along rays, front to back.
struct PacketSum
{
  Lanes3 color = { Lanes{}, Lanes{}, Lanes{} }; ///< premultiplied
  Lanes transmittance = All(1.0f);
  Lanes opticalDepth = {}; ///< optical depth of all parts; it is known before the transmittance

  void Add(const Optical& optical, Lanes lengthMm)
  {
    const Lanes depth = Min(optical.extinction * lengthMm, All(100.0f));
    this->opticalDepth += depth;
    const Lanes seen = this->transmittance * Absorption(depth);
    this->color = this->color + seen * optical.color;
    this->transmittance -= seen;
  }
};

inline PacketSum Select(LaneMask mask, const PacketSum& yes, const PacketSum& no)
{
  return { Select(mask, yes.color, no.color), Select(mask, yes.transmittance, no.transmittance),
    Select(mask, yes.opticalDepth, no.opticalDepth) };
}

/// The rays that go on from t.
inline LaneMask GoOn(
  const PacketScene& scene, const PacketRays& rays, Lanes t, const PacketSum& sum)
{
  return LaneMask(t < rays.exit) & LaneMask(sum.opticalDepth <= scene.steps.mostOpticalDepth);
}

/// True if rays do not contain all of a segment.
inline bool IsCut(const PacketRays& rays, Lanes enter, Lanes exit)
{
  return Any(LaneMask(enter < rays.enter) | LaneMask(exit > rays.exit));
}

/// The equal parts of a segment. A segment of the march of the whole may reach beyond the rays.
template <int Parts>
struct SegmentParts
{
  Lanes enter;           ///< the place where the segment begins
  Lanes partMm;          ///< 0 for a ray that has ended
  Lanes lengthMm[Parts]; ///< the length of each part inside the rays

  Lanes MiddleOf(int part) const { return this->enter + (float(part) + 0.5f) * this->partMm; }
};

/// @param isCut  true if the segment reaches beyond the rays
template <int Parts>
SegmentParts<Parts> PartsOf(const PacketRays& rays, Lanes enter, Lanes partMm, bool isCut)
{
  SegmentParts<Parts> parts = { enter, partMm, {} };
  for (int part = 0; part < Parts; ++part)
  {
    parts.lengthMm[part] = partMm;
  }
  if (isCut)
  {
    for (int part = 0; part < Parts; ++part)
    {
      const Lanes begin = enter + float(part) * partMm;
      parts.lengthMm[part] = rays.LengthBetween(begin, begin + partMm);
    }
  }
  return parts;
}

/// Marches segments of equal parts, each of which a rule adds to the sum.
/// @param before  the sum in front of the rays
/// @param take    (sum, parts of the segment, mask of the rays that have jumped here from the end
///                of the last segment)
template <int PartsPerSegment, class Take>
PacketSum MarchSegments(const PacketScene& scene, const PacketRays& rays, const PacketWalk& walk,
  const PacketSum& before, Take take)
{
  constexpr float Part = 1.0f / PartsPerSegment;
  const float plainMm = PartsPerSegment * scene.rays.stepMm;
  const bool areShared = scene.steps.areShared;
  const Lanes end = areShared ? rays.wholeExit : rays.exit;
  PacketSum sum = before;
  Lanes t = rays.enter;
  IntLanes index = areShared ? walk.SharedIndexAt(t, plainMm) : IntLanes{};
  LaneMask going = GoOn(scene, rays, t, sum);
  for (int count = 0; count < scene.rays.mostSegments && Any(going); ++count)
  {
    SegmentLanes segment;
    if (areShared)
    {
      const NumberedSegment numbered = walk.NextShared(index, plainMm, going);
      segment = { numbered.enter, numbered.exit };
      index = numbered.index + 1;
    }
    else
    {
      segment = walk.NextSegment(t, AllInt(count), plainMm, sum.opticalDepth, going);
    }
    going &= LaneMask(segment.enter < rays.exit);
    if (!Any(going))
    {
      break; // the rest is invisible
    }
    const LaneMask jumps = going & (LaneMask(segment.enter > t) | (AllInt(count) == 0));
    t = Min(segment.exit, end);
    const bool isCut = areShared && IsCut(rays, segment.enter, t);
    take(sum,
      PartsOf<PartsPerSegment>(
        rays, segment.enter, Select(going, (t - segment.enter) * Part, Lanes{}), isCut),
      jumps);
    going &= GoOn(scene, rays, t, sum);
  }
  return sum;
}

/// Reads the values at equal distances along rays.
template <class Voxels, int Count>
[[gnu::flatten]] void ReadValues(
  const Voxels& voxels, const PacketRays& rays, Lanes first, Lanes apart, Lanes (&values)[Count])
{
  ReadCells(
    voxels, [&](int i) { return rays.At(first + float(i) * apart); }, values);
}

}

}

#endif
