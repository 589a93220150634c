#ifndef Varimarch_Core_Packets_March_Extreme_h
#define Varimarch_Core_Packets_March_Extreme_h

// The largest or smallest value along rays.
// Twin of March/Extreme.glsl, March/ProjectedVoxels.glsl, Blend/MaximumIntensity.glsl,
// Blend/MinimumIntensity.glsl and Step/BrickExtremes.glsl.

#include "Core/Packets/Blend/Composite.h"
#include "Core/Packets/Classify/OpticalTable.h"
#include "Core/Packets/Interpolation/Linear.h"
#include "Core/Packets/PacketCellCubic.h"
#include "Core/Packets/PacketLattice.h"
#include "Core/Packets/PacketRays.h"
#include "Core/Packets/PacketScene.h"
#include "Core/Packets/ShaderMath.h"

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

}

}

#endif
