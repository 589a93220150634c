#ifndef Varimarch_Core_Packets_Reach_LightCells_h
#define Varimarch_Core_Packets_Reach_LightCells_h

// The lattice of a light, see LightLattice, as packets read and fill it.

#include "Core/Fields/LightLattice.h"
#include "Core/Packets/PacketRays.h"
#include "Core/Packets/PacketScene.h"
#include "Core/Packets/ShaderMath.h"

namespace varimarch
{

namespace
{

/// The light in the cells around some places.
struct LightInCells
{
  Lanes between; ///< interpolated between the nodes, [0, 1]
  Lanes spread;  ///< difference between the brightest and the darkest node
};

/// Nodes that are to be filled, at most one for each lane.
struct EmptyNodes
{
  std::int32_t of[LaneCount];
  int count = 0;

  bool Has(std::int32_t node) const
  {
    bool found = false;
    for (int i = 0; i < this->count; ++i)
    {
      found = found || this->of[i] == node;
    }
    return found;
  }
};

class LightCells
{
public:
  /// @param nodes  null: there is no lattice
  LightCells(std::uint8_t* nodes, const LatticeShape& shape)
    : nodes(nodes)
    , shape(shape)
    , nodeCount(shape.nodeCount)
  {
  }

  explicit operator bool() const { return this->nodes != nullptr; }

  /// The places that have nodes on all sides.
  LaneMask Contains(const Lanes3& placeGrid) const
  {
    const Lanes3 place = this->InNodes(placeGrid);
    const auto isWithin = [](Lanes number, int count)
    { return LaneMask(number >= 0.0f) & LaneMask(number <= float(count - 1)); };
    return isWithin(place.x, this->nodeCount.x) & isWithin(place.y, this->nodeCount.y) &
      isWithin(place.z, this->nodeCount.z);
  }

  /// Fills the nodes around places, and reads them.
  /// @param mask   the places that matter
  /// @param trace  (places [grid space], mask) -> the part of the light that reaches them
  template <class Trace>
  LightInCells LightAt(const Lanes3& placeGrid, LaneMask mask, Trace trace) const
  {
    const Lanes3 place = this->InNodes(placeGrid);
    const Lanes3 cell{ CellBelow(place.x, this->nodeCount.x), CellBelow(place.y, this->nodeCount.y),
      CellBelow(place.z, this->nodeCount.z) };
    const IntNumbers first(Truncated(cell.x) +
      this->nodeCount.x * (Truncated(cell.y) + this->nodeCount.y * Truncated(cell.z)));
    this->Fill(first, mask, trace);
    return this->Interpolated(first, Clamp(place - cell, Lanes3(0.0f), Lanes3(1.0f)));
  }

private:
  Lanes3 InNodes(const Lanes3& placeGrid) const
  {
    return (1.0f / float(this->shape.voxelsPerNode)) *
      (placeGrid + Lanes3(float(this->shape.margin)));
  }

  static Lanes CellBelow(Lanes number, int count)
  {
    return Floor(Clamp(number, 0.0f, All(float(count - 2))));
  }

  /// @param corner  from 0 to 7: a bit for each axis, that of x first
  std::int32_t OffsetOf(int corner) const
  {
    return (corner & 1) +
      this->nodeCount.x * ((corner >> 1 & 1) + this->nodeCount.y * (corner >> 2));
  }

  // Other threads may be filling a node, with the same number.
  std::uint8_t ByteAt(std::int32_t node) const
  {
    return __atomic_load_n(this->nodes + node, __ATOMIC_RELAXED);
  }

  template <class Trace>
  [[gnu::noinline]] void Fill(const IntNumbers& first, LaneMask mask, Trace trace) const
  {
    const IntNumbers isWanted(mask);
    EmptyNodes empty;
    for (int lane = 0; lane < LaneCount; ++lane)
    {
      for (int corner = 0; corner < 8 && isWanted.of[lane] != 0; ++corner)
      {
        const std::int32_t node = first.of[lane] + this->OffsetOf(corner);
        if (this->ByteAt(node) != LightLattice::Empty || empty.Has(node))
        {
          continue;
        }
        empty.of[empty.count++] = node;
        if (empty.count == LaneCount)
        {
          this->FillAll(empty, trace);
          empty.count = 0;
        }
      }
    }
    if (empty.count > 0)
    {
      this->FillAll(empty, trace);
    }
  }

  template <class Trace>
  void FillAll(const EmptyNodes& empty, Trace trace) const
  {
    const IntLanes node =
      IntLanesOf([&](int lane) { return empty.of[lane < empty.count ? lane : 0]; });
    const LaneMask mask = IntLanesOf([&](int lane) { return lane < empty.count ? -1 : 0; });
    const IntLanes row = node / this->nodeCount.x;
    const Lanes3 placeGrid = float(this->shape.voxelsPerNode) *
        Lanes3(FloatOf(node % this->nodeCount.x), FloatOf(row % this->nodeCount.y),
          FloatOf(row / this->nodeCount.y)) -
      Lanes3(float(this->shape.margin));
    constexpr float Steps = float(LightLattice::Full - LightLattice::Dark);
    const Lanes light = float(LightLattice::Dark) + Steps * trace(placeGrid, mask);
    const IntNumbers bytes(Truncated(light + 0.5f));
    for (int i = 0; i < empty.count; ++i)
    {
      __atomic_store_n(this->nodes + empty.of[i], std::uint8_t(bytes.of[i]), __ATOMIC_RELAXED);
    }
  }

  LightInCells Interpolated(const IntNumbers& first, const Lanes3& part) const
  {
    const auto corner = [&](int index)
    {
      const std::int32_t offset = this->OffsetOf(index);
      return FloatOf(
        IntLanesOf([&](int lane) { return std::int32_t(this->ByteAt(first.of[lane] + offset)); }));
    };
    const Lanes corners[8] = { corner(0), corner(1), corner(2), corner(3), corner(4), corner(5),
      corner(6), corner(7) };
    Lanes least = corners[0];
    Lanes most = corners[0];
    for (const Lanes& light : corners)
    {
      least = Min(least, light);
      most = Max(most, light);
    }
    const auto alongX = [&](int pair) { return Mix(corners[pair], corners[pair + 1], part.x); };
    const Lanes between =
      Mix(Mix(alongX(0), alongX(2), part.y), Mix(alongX(4), alongX(6), part.y), part.z);
    constexpr float PerByte = 1.0f / float(LightLattice::Full - LightLattice::Dark);
    return { PerByte * (between - float(LightLattice::Dark)), PerByte * (most - least) };
  }

  std::uint8_t* nodes;
  LatticeShape shape;
  glm::ivec3 nodeCount;
};

}

}

#endif
