#ifndef Varimarch_Core_Packets_Projections_h
#define Varimarch_Core_Packets_Projections_h

// The largest, smallest or mean value along rays, and the sum of all values.
// Twin of March/Extreme.glsl, March/ProjectedVoxels.glsl, Blend/MaximumIntensity.glsl,
// Blend/MinimumIntensity.glsl, Step/BrickExtremes.glsl, March/Projection.glsl, Sample/Scalar.glsl,
// Blend/AverageIntensity.glsl, Blend/Additive.glsl and March/RangeMean.glsl.

#include "Core/Packets/Looks.h"
#include "Core/Packets/PacketScene.h"
#include "Core/Packets/Rays.h"
#include "Core/Packets/ShaderMath.h"
#include "Core/Packets/Voxels.h"
#include "Core/Packets/Walk.h"

#include <algorithm>

namespace varimarch
{

namespace
{

/// Cells between eight voxels each, in which the values along rays are cubics. The space before the
/// first voxel and behind the last one is divided into cells too.
/// @tparam Voxels  PacketVoxels or AnyVoxels
template <class Voxels>
class CubicCells
{
public:
  explicit CubicCells(const PacketScene& scene)
    : voxels(scene)
    , cellCount(scene.volume.voxelCount + 1)
  {
  }

  PacketLattice LatticeOf(const PacketRays& rays) const
  {
    return PacketLattice(rays, 1.0f, -1.0f, this->cellCount);
  }

  /// The best value that the rays of a mask have found when they leave a cell.
  Lanes BetterOf(const PacketRays& rays, const LatticePlace& place, Lanes exit, float sense,
    Lanes found, LaneMask mask) const
  {
    const Lanes4 cubic = All(sense) *
      CubicBetween(this->voxels.CornersOf(place.cell - 1.0f), rays.At(place.t), rays.At(exit));
    Lanes best = Max(found, Max(cubic.x, cubic.w));
    if (Any(mask & LaneMask(Max(cubic.y, cubic.z) > best)))
    {
      const Lanes2 places = CubicExtremes(cubic);
      best = Max(best, Max(CubicValue(cubic, places.x), CubicValue(cubic, places.y)));
    }
    return Select(mask, best, found);
  }

private:
  Voxels voxels;
  glm::ivec3 cellCount;
};

/// Boxes of voxels without interpolation.
/// @tparam Boxes  PacketBoxes or AnyBoxes
template <class Boxes>
class BoxCells
{
public:
  explicit BoxCells(const PacketScene& scene)
    : boxes(scene)
  {
  }

  PacketLattice LatticeOf(const PacketRays& rays) const { return this->boxes.LatticeOf(rays); }

  /// See CubicCells. A box that a ray merely touches is ignored: rounding may find one where the
  /// ray begins or ends.
  Lanes BetterOf(const PacketRays& rays, const LatticePlace& place, Lanes exit, float sense,
    Lanes found, LaneMask mask) const
  {
    constexpr float ShortestVoxels = 2e-5f;
    const LaneMask isSeen =
      mask & LaneMask((exit - place.t) * Length(rays.directionGrid) > ShortestVoxels);
    return Select(isSeen, Max(found, sense * this->boxes.ValueOf(place.cell)), found);
  }

private:
  Boxes boxes;
};

/// A march keeps the best value in the x of a PacketSum's colour; the optical depth ends rays that
/// cannot find a better one.
inline PacketSum NothingFound()
{
  PacketSum sum;
  sum.color.x = All(-Never);
  return sum;
}

/// Shaders/Blend/MaximumIntensity.glsl: the colour of the best value.
inline PacketSum SeenOfExtreme(const PacketScene& scene, const PacketSum& march)
{
  const Lanes found = march.color.x;
  const LaneMask hasFound = LaneMask(found > -Never);
  const Lanes value = Select(hasFound, scene.parameters.sense * found, Lanes{});
  PacketSum sum;
  sum.Add(Classify(scene.look, value),
    Select(hasFound, All(scene.parameters.opacityUnitDistancesMm.x), Lanes{}));
  return sum;
}

/// A march from each brick that may hold a better value to the next one.
/// @tparam Cells  CubicCells or BoxCells
template <class Cells>
class ExtremeMarch
{
public:
  ExtremeMarch(const PacketScene& scene, const PacketRays& rays, const PacketSum& before)
    : scene(scene)
    , extreme(scene.extreme)
    , rays(rays)
    , cells(scene)
    , lattice(this->cells.LatticeOf(rays))
    , bricks(rays, scene.parameters.cellsPerBrick, 0.0f, scene.extreme.brickCount)
    , blocks(rays, scene.parameters.cellsPerBrick * scene.extreme.bricksPerBlock, 0.0f,
        scene.extreme.blockCount)
    , sense(scene.parameters.sense)
    , best(sense > 0.0f ? scene.parameters.largestScalars.x : -scene.parameters.smallestScalars.x)
    , found(before.color.x)
  {
  }

  PacketSum March()
  {
    const Lanes segmentMm = CellsPerSegment / Length(this->rays.directionGrid);
    Lanes t = this->rays.enter;
    LaneMask going = LaneMask(t < this->rays.exit);
    for (int index = 0; index < this->scene.rays.mostSegments && Any(going); ++index)
    {
      t = this->extreme.bricks ? this->NextBrick(t, going) : t;
      going &= LaneMask(t < this->rays.exit);
      t = this->MarchCells(t, Min(t + segmentMm, this->rays.exit), going);
      going &= LaneMask(t < this->rays.exit) & LaneMask(this->found < this->best);
    }
    PacketSum sum;
    sum.color.x = this->found;
    sum.opticalDepth = Select(LaneMask(this->found < this->best), Lanes{}, All(Never));
    return sum;
  }

private:
  static constexpr float CellsPerSegment = 4.0f;

  // The place where the rays of a mask reach a brick that may hold a better value.
  Lanes NextBrick(Lanes t, LaneMask mask) const
  {
    mask &= this->IsLeft(this->extreme.bricks, this->bricks, this->bricks.At(t).cell);
    if (!Any(mask))
    {
      return t;
    }
    LatticePlace block = this->blocks.At(t);
    while (Any(mask))
    {
      block = this->Behind(this->extreme.blocks, this->blocks, block, mask, All(Never));
      const LatticePlace next = this->blocks.Behind(block);
      const LatticePlace brick =
        this->Behind(this->extreme.bricks, this->bricks, this->bricks.At(block.t), mask, next.t);
      t = Select(mask, brick.t, t);
      block = next;
      mask &= LaneMask(t >= next.t) & LaneMask(t < this->rays.exit);
    }
    return t;
  }

  // The place behind the cells of a lattice that the rays of a mask can skip from here, not beyond
  // an end.
  LatticePlace Behind(const std::uint16_t* steps, const PacketLattice& lattice, LatticePlace place,
    LaneMask mask, Lanes end) const
  {
    const Lanes last = Min(end, this->rays.exit);
    for (mask &= LaneMask(place.t < last); Any(mask); mask &= LaneMask(place.t < last))
    {
      mask &= this->IsLeft(steps, lattice, place.cell);
      place = Select(mask, lattice.Behind(place), place);
    }
    return place;
  }

  // The rays for which a cell holds no better value.
  LaneMask IsLeft(
    const std::uint16_t* steps, const PacketLattice& lattice, const Lanes3& cell) const
  {
    const IntNumbers index = lattice.IndexOf(cell);
    const IntLanes all = IntLanesOf([&](int lane) { return std::int32_t(steps[index.of[lane]]); });
    const glm::vec2& scalar = this->scene.parameters.scalarFromField;
    return LaneMask(this->sense * (FloatOf(all) * scalar.x + scalar.y) <= this->found);
  }

  // Marches the rays of a mask to the end of the cell that contains `end`.
  Lanes MarchCells(Lanes t, Lanes end, LaneMask mask)
  {
    LatticePlace place = this->lattice.At(t);
    while (Any(mask))
    {
      const LatticePlace behind = this->lattice.Behind(place);
      const Lanes exit = Min(behind.t, this->rays.exit);
      this->found = this->cells.BetterOf(this->rays, place, exit, this->sense, this->found, mask);
      place = Select(mask, behind, place);
      mask &= LaneMask(place.t < end);
    }
    return place.t;
  }

  const PacketScene& scene;
  const PacketExtreme& extreme;
  const PacketRays& rays;
  Cells cells;
  PacketLattice lattice; ///< lattice of cells
  PacketLattice bricks;
  PacketLattice blocks; ///< lattice of blocks of bricks
  float sense;          ///< 1: a maximum; -1: a minimum, of which all values are negated
  float best;           ///< no value is better
  Lanes found;
};

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

// The mean of the values in a range: each cell's cubic is divided where it enters and leaves the
// range, so that no part that counts is missed.

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
