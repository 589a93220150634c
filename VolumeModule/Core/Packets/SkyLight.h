#ifndef Varimarch_Core_Packets_SkyLight_h
#define Varimarch_Core_Packets_SkyLight_h

// Light from all around, as far as matter near a place lets it through: ambient occlusion.
// Twin of Sky/OpenSky.glsl, Outside/Scalars.glsl and Outside/Labels.glsl.

#include "Core/Fields/LightLattice.h"
#include "Core/Packets/LightRays.h"
#include "Core/Packets/PacketScene.h"
#include "Core/Packets/Rays.h"
#include "Core/Packets/ShaderMath.h"

namespace varimarch
{

namespace
{

// The lattice of a light, see LightLattice, as packets read and fill it.

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

/// All constituents of a mixture; a volume that is no mixture is the only one.
class AllConstituents
{
public:
  explicit AllConstituents(const PacketScene& first)
    : first(first)
  {
  }

  int Count() const { return this->first.constituent.otherCount + 1; }

  const PacketScene& operator[](int index) const
  {
    return index == 0 ? this->first : this->first.constituent.others[index - 1];
  }

private:
  const PacketScene& first;
};

/// Places in the grid of a volume, for places in that of another one.
inline Lanes3 PlaceInGridOf(
  const VolumeParameters& volume, const VolumeParameters& other, const Lanes3& placeGrid)
{
  const Lanes3 world =
    Transformed(other.worldFromGrid, placeGrid) + AllOf3(other.worldOfGridOrigin);
  return Transformed(volume.gridFromWorld, world - AllOf3(volume.worldOfGridOrigin));
}

/// The optical depth of a volume from places on, as far as light from all around is taken.
/// @param direction  its index in PacketSky
/// @param isOfNodes  true for the places of nodes of the lattice
inline Lanes OwnSkyDepth(
  const PacketScene& scene, int direction, const Lanes3& placeGrid, LaneMask mask, bool isOfNodes)
{
  PacketRays rays;
  rays.originGrid = placeGrid;
  rays.directionGrid = AllOf3(scene.sky.directions[direction]);
  rays.inverse = SafeInverse(rays.directionGrid);
  rays.region = IntLanes{};
  rays.enter = Lanes{};
  rays.exit = All(scene.sky.reachMm);
  KeepUncut(rays, scene);
  // A surface is farther from its place than the first segment.
  const float longestMm = isOfNodes ? scene.sky.nodeStepMm : scene.sky.stepMm;
  const ShadowMarch march = { longestMm, All(0.5f * longestMm), scene.sky.mostDepth };
  return DepthAlong(scene, rays, march, mask, KnownDepths(rays));
}

/// The optical depth of all constituents from places on, in the grid of one of them.
inline Lanes SkyDepth(const PacketScene& scene, const AllConstituents& all, int direction,
  const Lanes3& placeGrid, LaneMask mask, bool isOfNodes)
{
  if (!scene.constituent.isOfMixture)
  {
    return OwnSkyDepth(scene, direction, placeGrid, mask, isOfNodes);
  }
  Lanes depth = {};
  for (int i = 0; i < all.Count(); ++i)
  {
    const LaneMask counts = mask & LaneMask(depth < scene.sky.mostDepth);
    if (!Any(counts))
    {
      break;
    }
    const PacketScene& other = all[i];
    const Lanes own = OwnSkyDepth(other, direction,
      PlaceInGridOf(other.parameters, scene.parameters, placeGrid), counts, isOfNodes);
    depth = depth + Select(counts, own, Lanes{});
  }
  return depth;
}

/// The part of the light from all around that reaches places in a volume. Where it is traced,
/// places that follow each other at less than half of a segment are extrapolated from those before.
class OpenSky
{
public:
  /// @param scene  the one with the places
  /// @param first  the first constituent of its mixture, or itself
  OpenSky(const PacketScene& scene, const PacketScene& first)
    : scene(scene)
    , all(first)
    , cells(scene.sky.nodes, scene.sky.shape)
  {
  }

  /// @param mask  the places that matter
  [[gnu::noinline]] Lanes At(const Lanes3& placeGrid, LaneMask mask)
  {
    if (!this->cells)
    {
      return this->Followed(placeGrid, mask);
    }
    LaneMask agrees = mask & this->cells.Contains(placeGrid);
    const LightInCells found = this->cells.LightAt(placeGrid, agrees,
      [&](const Lanes3& nodeGrid, LaneMask nodes) { return this->Traced(nodeGrid, nodes, true); });
    agrees &= LaneMask(found.spread <= this->scene.sky.agreement);
    const LaneMask others = mask & ~agrees;
    return Any(others) ? Select(others, this->Followed(placeGrid, others), found.between)
                       : found.between;
  }

private:
  // A packet is traced for all of its places if one of them asks for it.
  Lanes Followed(const Lanes3& placeGrid, LaneMask mask)
  {
    const Lanes movedMm =
      Length(Transformed(this->scene.parameters.worldFromGrid, placeGrid - this->lastGrid));
    // The light of boxes of voxels jumps.
    const bool isOfBoxes = this->scene.rule == PacketRule::MaterialVoxels;
    const float longestMm = isOfBoxes ? 0.0f : 0.5f * this->scene.sky.stepMm;
    const LaneMask follows = this->isKnown & LaneMask(movedMm <= longestMm);
    if (!Any(mask & ~follows))
    {
      return Clamp(this->lastOpen + movedMm * this->changePerMm, 0.0f, 1.0f);
    }
    const Lanes open = this->Traced(placeGrid, mask, false);
    const LaneMask goesOn = mask & this->isKnown & LaneMask(movedMm < 2.0f * longestMm);
    this->changePerMm =
      Select(goesOn, (open - this->lastOpen) / Max(movedMm, All(1e-6f * longestMm)), Lanes{});
    this->lastOpen = open;
    this->lastGrid = placeGrid;
    this->isKnown = mask;
    return open;
  }

  [[gnu::noinline]] Lanes Traced(const Lanes3& placeGrid, LaneMask mask, bool isOfNodes) const
  {
    Lanes seen = {};
    for (int i = 0; i < SphereDirections; ++i)
    {
      const Lanes depth = SkyDepth(this->scene, this->all, i, placeGrid, mask, isOfNodes);
      seen = seen + this->scene.sky.directions[i].w * Exp(-depth);
    }
    return KeptLight(seen, All(this->scene.sky.strength));
  }

  const PacketScene& scene;
  AllConstituents all;
  LightCells cells;
  Lanes3 lastGrid = Lanes3(0.0f); ///< the places that were traced last
  Lanes lastOpen = {};
  Lanes changePerMm = {}; ///< change of the light when these places were reached
  LaneMask isKnown = {};  ///< the rays that had such places
};

}

}

#endif
