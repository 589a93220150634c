#ifndef Varimarch_Core_Packets_March_Projection_h
#define Varimarch_Core_Packets_March_Projection_h

// The mean or the sum of the values along rays.
// Twin of March/Projection.glsl, Sample/Scalar.glsl, Blend/AverageIntensity.glsl and
// Blend/Additive.glsl.

#include "Core/Packets/Blend/Composite.h"
#include "Core/Packets/Classify/OpticalTable.h"
#include "Core/Packets/Loop/Segments.h"
#include "Core/Packets/PacketRays.h"
#include "Core/Packets/PacketScene.h"
#include "Core/Packets/ShaderMath.h"
#include "Core/Packets/Step/OpticalField.h"

namespace varimarch
{

namespace
{

/// A march keeps the integral [mm] in the x of a PacketSum's colour, and the length that counts
/// [mm] in its y; the optical depth ends rays that are white. The image is white on black; a ray
/// without any sample is transparent.
inline PacketSum SeenOfProjection(const PacketScene& scene, const PacketSum& march)
{
  const VolumeParameters& parameters = scene.parameters;
  const Lanes lengthMm =
    scene.isMean ? Max(march.color.y, All(1e-30f)) : All(parameters.opacityUnitDistancesMm.x);
  const LaneMask hasSample = LaneMask(march.color.y > 0.0f);
  const Lanes white =
    Select(hasSample, Clamp(march.color.x / lengthMm, Lanes{}, All(1.0f)), Lanes{});
  PacketSum sum;
  sum.color = { white, white, white };
  sum.transmittance = Select(hasSample, Lanes{}, All(1.0f));
  return sum;
}

/// The integral and the length of values along rays.
class ProjectedSum
{
public:
  ProjectedSum(const PacketScene& scene, const PacketSum& before)
    : scene(scene)
    , parameters(scene.parameters)
    , integral(before.color.x)
    , lengthMm(before.color.y)
  {
  }

  void Add(Lanes value, Lanes lengthMm)
  {
    const Lanes countedMm = Select(this->Counts(value), lengthMm, Lanes{});
    this->lengthMm += countedMm;
    if (Any(MayAbsorb(this->scene.look, value, value)))
    {
      const Lanes extinction = Classify(this->scene.look, value).extinction;
      const Lanes opacity = Absorption(extinction * this->parameters.opacityUnitDistancesMm.x);
      const Lanes gray =
        (value - this->parameters.smallestScalars.x) * this->parameters.grayPerScalars.x;
      this->integral += opacity * gray * countedMm;
    }
  }

  // A sum is at most white; a mean may always become darker.
  LaneMask IsWhite() const
  {
    return LaneMask(this->integral >= this->parameters.opacityUnitDistancesMm.x) &
      AllInt(this->scene.isMean ? 0 : -1);
  }

  PacketSum Sum() const
  {
    PacketSum sum;
    sum.color.x = this->integral;
    sum.color.y = this->lengthMm;
    sum.opticalDepth = Select(this->IsWhite(), All(Never), Lanes{});
    return sum;
  }

private:
  LaneMask Counts(Lanes value) const
  {
    return (LaneMask(value >= this->parameters.averagedLower.x) &
             LaneMask(value <= this->parameters.averagedUpper.x)) |
      AllInt(this->scene.isMean ? 0 : -1);
  }

  const PacketScene& scene;
  const VolumeParameters& parameters;
  Lanes integral; ///< [mm]
  Lanes lengthMm; ///< length of the samples that count
};

/// A march of segments of equal parts. A part that a ray skips is as invisible throughout as its
/// first point, but its length counts.
template <class Voxels>
class ProjectionMarch
{
public:
  ProjectionMarch(const PacketScene& scene, const PacketRays& rays, const PacketWalk& walk,
    const PacketSum& before)
    : scene(scene)
    , rays(rays)
    , walk(walk)
    , voxels(scene)
    , gathered(scene, before)
  {
  }

  PacketSum March()
  {
    Lanes t = this->rays.enter;
    LaneMask going = LaneMask(t < this->rays.exit);
    for (int index = 0; index < this->scene.rays.mostSegments && Any(going); ++index)
    {
      const SegmentLanes segment = this->walk.NextSegment(
        t, AllInt(index), PartsPerSegment * this->scene.rays.stepMm, Lanes{}, going);
      const LaneMask leavesOut = going & LaneMask(segment.enter > t);
      if (Any(leavesOut))
      {
        const Lanes leftOutMm = Min(segment.enter, this->rays.exit) - t;
        this->gathered.Add(
          this->voxels.ValueAt(this->rays.At(t)), Select(leavesOut, leftOutMm, Lanes{}));
      }
      going &= LaneMask(segment.enter < this->rays.exit);
      t = Min(segment.exit, this->rays.exit);
      this->AddParts(segment.enter, Select(going, t - segment.enter, Lanes{}));
      going &= LaneMask(t < this->rays.exit) & ~this->gathered.IsWhite();
    }
    return this->gathered.Sum();
  }

private:
  static constexpr int PartsPerSegment = 4;

  void AddParts(Lanes enter, Lanes lengthMm)
  {
    const Lanes partMm = (1.0f / PartsPerSegment) * lengthMm;
    Lanes values[PartsPerSegment];
    ReadValues(this->voxels, this->rays, enter + 0.5f * partMm, partMm, values);
    for (const Lanes& value : values)
    {
      this->gathered.Add(value, partMm);
    }
  }

  const PacketScene& scene;
  const PacketRays& rays;
  const PacketWalk& walk;
  Voxels voxels;
  ProjectedSum gathered;
};

}

}

#endif
