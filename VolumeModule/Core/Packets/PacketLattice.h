#ifndef Varimarch_Core_Packets_PacketLattice_h
#define Varimarch_Core_Packets_PacketLattice_h

// The walk of the rays of a packet through the cells of a lattice: Shaders/Math/LatticeWalk.glsl.

#include "Core/Packets/Lanes.h"
#include "Core/Packets/PacketRays.h"

namespace varimarch
{

namespace
{

/// The places of rays: a cell, and t [mm].
struct LatticePlaces
{
  Lanes3 cell; ///< whole numbers; may be beyond the lattice, where a ray has left it
  Lanes t;
};

inline LatticePlaces Select(LaneMask mask, const LatticePlaces& yes, const LatticePlaces& no)
{
  return { { Select(mask, yes.cell.x, no.cell.x), Select(mask, yes.cell.y, no.cell.y),
             Select(mask, yes.cell.z, no.cell.z) },
    Select(mask, yes.t, no.t) };
}

class PacketLattice
{
public:
  /// @param cellSideGrid   length of a cell's side, in voxels
  /// @param firstCellGrid  where cell 0 begins, on each axis
  PacketLattice(
    const PacketRays& rays, float cellSideGrid, float firstCellGrid, const glm::ivec3& cellCount)
    : origin(All(1.0f / cellSideGrid) *
        (rays.originGrid - Lanes3{ All(firstCellGrid), All(firstCellGrid), All(firstCellGrid) }))
    , direction(All(1.0f / cellSideGrid) * rays.directionGrid)
    , inverse(All(cellSideGrid) * rays.inverse)
    , outward{ WithSignOf(All(1.0f), rays.inverse.x), WithSignOf(All(1.0f), rays.inverse.y),
      WithSignOf(All(1.0f), rays.inverse.z) }
    , fromFace(
        All(0.5f) * (this->outward + Lanes3{ All(1.0f), All(1.0f), All(1.0f) }) - this->origin)
    , last{ All(float(cellCount.x - 1)), All(float(cellCount.y - 1)), All(float(cellCount.z - 1)) }
    , cellsPerRow(cellCount.x)
    , cellsPerSlice(cellCount.x * cellCount.y)
  {
  }

  LatticePlaces At(Lanes t) const
  {
    return { this->Inside({ Floor(this->origin.x + t * this->direction.x),
               Floor(this->origin.y + t * this->direction.y),
               Floor(this->origin.z + t * this->direction.z) }),
      t };
  }

  /// The indices of cells in memory; outside the lattice, that of the nearest cell.
  IntNumbers IndexOf(const Lanes3& cell) const
  {
    const Lanes3 inside = this->Inside(cell);
    return IntNumbers(Truncated(inside.x) + this->cellsPerRow * Truncated(inside.y) +
      this->cellsPerSlice * Truncated(inside.z));
  }

  /// The places where rays leave their cells, with the cells that they enter.
  LatticePlaces Behind(const LatticePlaces& place) const
  {
    const Lanes3 exits = this->ExitsOf(place.cell);
    const Lanes exit = Min(Min(exits.x, exits.y), exits.z);
    const auto next = [&](Lanes cell, Lanes outward, Lanes alongExit)
    { return Select(LaneMask(alongExit <= exit), cell + outward, cell); };
    return { { next(place.cell.x, this->outward.x, exits.x),
               next(place.cell.y, this->outward.y, exits.y),
               next(place.cell.z, this->outward.z, exits.z) },
      Max(place.t, exit) };
  }

  /// The same for blocks of this radius around the cells.
  LatticePlaces BehindBlock(const LatticePlaces& place, Lanes radius) const
  {
    const Lanes3 farthest = place.cell + radius * this->outward;
    const Lanes3 exits = this->ExitsOf(farthest);
    const Lanes exit = Min(Min(exits.x, exits.y), exits.z);
    const Lanes t = Max(place.t, exit);
    const auto next = [&](Lanes cell, Lanes last, Lanes outward, Lanes alongExit, Lanes position)
    {
      const Lanes within = Clamp(Floor(position), cell - radius, cell + radius);
      return Select(LaneMask(alongExit <= exit), last + outward, within);
    };
    const Lanes3 position = this->origin + t * this->direction;
    return { { next(place.cell.x, farthest.x, this->outward.x, exits.x, position.x),
               next(place.cell.y, farthest.y, this->outward.y, exits.y, position.y),
               next(place.cell.z, farthest.z, this->outward.z, exits.z, position.z) },
      t };
  }

private:
  Lanes3 Inside(const Lanes3& cell) const
  {
    return { Clamp(cell.x, Lanes{}, this->last.x), Clamp(cell.y, Lanes{}, this->last.y),
      Clamp(cell.z, Lanes{}, this->last.z) };
  }

  // The t at which rays meet the faces through which they leave cells.
  Lanes3 ExitsOf(const Lanes3& cell) const
  {
    return { (cell.x + this->fromFace.x) * this->inverse.x,
      (cell.y + this->fromFace.y) * this->inverse.y,
      (cell.z + this->fromFace.z) * this->inverse.z };
  }

  Lanes3 origin; ///< in cells
  Lanes3 direction;
  Lanes3 inverse;
  Lanes3 outward;  ///< 1 on axes along which rays ascend, else -1
  Lanes3 fromFace; ///< from the origin to the face through which rays leave cell 0
  Lanes3 last;
  int cellsPerRow;
  int cellsPerSlice;
};

}

}

#endif
