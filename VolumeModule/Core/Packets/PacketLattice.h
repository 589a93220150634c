#ifndef Varimarch_Core_Packets_PacketLattice_h
#define Varimarch_Core_Packets_PacketLattice_h

// The walk of the rays of a packet through the cells of a lattice: Shaders/Math/LatticeWalk.glsl.

#include "Core/Packets/PacketRays.h"
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

}

}

#endif
