#ifndef Varimarch_Core_Packets_March_RangeMean_h
#define Varimarch_Core_Packets_March_RangeMean_h

// The mean of the values in a range: each cell's cubic is divided where it enters and leaves the
// range, so that no part that counts is missed.
// Twin of March/RangeMean.glsl.

#include "Core/Packets/Interpolation/Linear.h"
#include "Core/Packets/March/Projection.h"
#include "Core/Packets/PacketCellCubic.h"
#include "Core/Packets/PacketLattice.h"
#include "Core/Packets/PacketRays.h"
#include "Core/Packets/PacketScene.h"
#include "Core/Packets/ShaderMath.h"

#include <algorithm>

namespace varimarch
{

namespace
{

/// A march through all cells; it keeps what that of a projection keeps.
template <class Voxels>
class RangeMeanMarch
{
public:
  RangeMeanMarch(const PacketScene& scene, const PacketRays& rays, const PacketSum& before)
    : parameters(scene.parameters)
    , stepMm(scene.rays.stepMm)
    , rays(rays)
    , voxels(scene)
    // The space before the first voxel and behind the last one is divided into cells too.
    , cells(rays, 1.0f, -1.0f, scene.volume.voxelCount + 1)
    , gathered(scene, before)
  {
  }

  PacketSum March()
  {
    LatticePlace place = this->cells.At(this->rays.enter);
    LaneMask going = LaneMask(place.t < this->rays.exit);
    while (Any(going))
    {
      const LatticePlace behind = this->cells.Behind(place);
      const Lanes exit = Min(behind.t, this->rays.exit);
      this->AddCell(CubicBetween(this->voxels.CornersOf(place.cell - 1.0f), this->rays.At(place.t),
                      this->rays.At(exit)),
        Select(going, exit - place.t, Lanes{}));
      place = Select(going, behind, place);
      going &= LaneMask(place.t < this->rays.exit);
    }
    return this->gathered.Sum();
  }

private:
  struct Range
  {
    Lanes lower;
    Lanes upper;
  };

  // A value at an end of the range counts, although the cubic rounds it.
  Range RangeFor(const Lanes4& cubic) const
  {
    const Lanes largest = Max(Max(Abs(cubic.x), Abs(cubic.y)), Max(Abs(cubic.z), Abs(cubic.w)));
    const Lanes rounding = 1e-6f * largest;
    return { this->parameters.averagedLower.x - rounding,
      this->parameters.averagedUpper.x + rounding };
  }

  // A cell with a length of 0 is of a ray that has ended.
  void AddCell(const Lanes4& cubic, Lanes cellMm)
  {
    const Range range = this->RangeFor(cubic);
    const Lanes low = Min(Min(cubic.x, cubic.y), Min(cubic.z, cubic.w));
    const Lanes high = Max(Max(cubic.x, cubic.y), Max(cubic.z, cubic.w));
    const LaneMask holds =
      LaneMask(cellMm > 0.0f) & LaneMask(high >= range.lower) & LaneMask(low <= range.upper);
    const LaneMask isWhole = holds & LaneMask(low >= range.lower) & LaneMask(high <= range.upper);
    if (Any(isWhole))
    {
      this->AddCounted(cubic, { Lanes{}, All(1.0f) }, Select(isWhole, cellMm, Lanes{}));
    }
    const LaneMask isDivided = holds & ~isWhole;
    if (Any(isDivided))
    {
      const Lanes2 extremes = CubicExtremes(cubic);
      const Lanes dividedMm = Select(isDivided, cellMm, Lanes{});
      this->AddMonotone(cubic, { Lanes{}, extremes.x }, range, dividedMm);
      this->AddMonotone(cubic, { extremes.x, extremes.y }, range, dividedMm);
      this->AddMonotone(cubic, { extremes.y, All(1.0f) }, range, dividedMm);
    }
  }

  // Adds what is in a range of one piece of a cell.
  void AddMonotone(
    const Lanes4& cubic, const MonotonePiece& piece, const Range& range, Lanes cellMm)
  {
    const Lanes first = CubicValue(cubic, piece.begin);
    const Lanes last = CubicValue(cubic, piece.end);
    const Lanes low = Min(first, last);
    const Lanes high = Max(first, last);
    const LaneMask holds =
      LaneMask(cellMm > 0.0f) & LaneMask(high >= range.lower) & LaneMask(low <= range.upper);
    Lanes atLow = Select(LaneMask(first <= last), piece.begin, piece.end);
    Lanes atHigh = piece.begin + piece.end - atLow;
    const LaneMask enters = holds & LaneMask(low < range.lower);
    atLow = Select(enters, CrossingOf(cubic, range.lower, piece, enters), atLow);
    const LaneMask leaves = holds & LaneMask(high > range.upper);
    atHigh = Select(leaves, CrossingOf(cubic, range.upper, piece, leaves), atHigh);
    this->AddCounted(
      cubic, { Min(atLow, atHigh), Max(atLow, atHigh) }, Select(holds, cellMm, Lanes{}));
  }

  // Adds a part of a cell, all of which counts.
  void AddCounted(const Lanes4& cubic, const MonotonePiece& part, Lanes cellMm)
  {
    const Lanes lengthMm = (part.end - part.begin) * cellMm;
    const Lanes count = Min(Floor(lengthMm / this->stepMm), All(MostParts - 1.0f)) + 1.0f;
    const Lanes partMm = lengthMm / count;
    LaneMask going = LaneMask(lengthMm > 0.0f);
    for (Lanes index = Lanes{}; Any(going); index += 1.0f)
    {
      const Lanes u = part.begin + (index + 0.5f) / count * (part.end - part.begin);
      const Lanes value = Clamp(CubicValue(cubic, u), All(this->parameters.averagedLower.x),
        All(this->parameters.averagedUpper.x));
      this->gathered.Add(value, Select(going, partMm, Lanes{}));
      going &= LaneMask(index + 1.0f < count);
    }
  }

  static constexpr float MostParts = 1024.0f;

  const VolumeParameters& parameters;
  float stepMm;
  const PacketRays& rays;
  Voxels voxels;
  PacketLattice cells;
  ProjectedSum gathered;
};

}

}

#endif
