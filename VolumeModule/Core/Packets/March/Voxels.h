#ifndef Varimarch_Core_Packets_March_Voxels_h
#define Varimarch_Core_Packets_March_Voxels_h

// Voxels without interpolation: boxes of one value, which extend half a voxel to every side.
// Twin of March/Voxels.glsl and Loop/Cells.glsl.

#include "Core/Packets/Classify/OpticalTable.h"
#include "Core/Packets/Interpolation/Linear.h"
#include "Core/Packets/Loop/Segments.h"
#include "Core/Packets/PacketLattice.h"

#include <type_traits>

namespace varimarch
{

namespace
{

/// @param index  index of each lane's voxel, counted from `first`
template <class Voxel, class Indices>
Lanes ValuesAt(const Voxel* first, const Indices& index)
{
  if constexpr (std::is_same_v<Voxel, float>)
  {
    return LanesOf([&](int lane) { return first[index.of[lane]]; });
  }
  else
  {
    return FloatOf(IntLanesOf([&](int lane) { return std::int32_t(first[index.of[lane]]); }));
  }
}

/// Voxels of a type.
template <class Content>
class BoxValues
{
public:
  explicit BoxValues(const PacketVolume& volume)
    : first(static_cast<const Voxel*>(volume.voxels))
    , strides(volume.voxelCount)
  {
  }

  Lanes Of(IntLanes x, IntLanes y, IntLanes z) const
  {
    return ValuesAt(this->first, this->strides.IndexOf(x, y, z));
  }

private:
  using Voxel = typename VoxelsOf<Content>::Voxel;

  const Voxel* first;
  VoxelStrides<typename VoxelsOf<Content>::Indices> strides;
};

/// Many voxels, whose type is looked up each time.
template <>
class BoxValues<ManyVoxels>
{
public:
  explicit BoxValues(const PacketVolume& volume)
    : volume(volume)
  {
  }

  [[gnu::noinline]] Lanes Of(IntLanes x, IntLanes y, IntLanes z) const
  {
    return ByVoxelType(this->volume.type,
      [&](auto voxel) { return BoxValues<Many<decltype(voxel)>>(this->volume).Of(x, y, z); });
  }

private:
  PacketVolume volume;
};

/// The boxes, as the cells of a lattice. The outermost ones extend beyond the volume.
/// @tparam Content  see PacketTile.h
template <class Content>
class PacketBoxes
{
public:
  explicit PacketBoxes(const PacketVolume& volume)
    : values(volume)
    , count(volume.voxelCount)
  {
  }

  PacketLattice LatticeOf(const PacketRays& rays) const
  {
    return PacketLattice(rays, 1.0f, -0.5f, this->count);
  }

  /// @param voxel  whole numbers
  Lanes ValueOf(const Lanes3& voxel) const
  {
    return this->values.Of(
      this->WithinAxis(voxel.x, 0), this->WithinAxis(voxel.y, 1), this->WithinAxis(voxel.z, 2));
  }

  Lanes ValueAt(const Lanes3& placeGrid) const { return this->ValueOf(Floor(placeGrid + 0.5f)); }

  /// Differences one voxel to either side.
  Lanes3 GradientOf(const Lanes3& voxel) const
  {
    const auto along = [&](float x, float y, float z)
    {
      const Lanes3 step{ All(x), All(y), All(z) };
      return this->ValueOf(voxel + step) - this->ValueOf(voxel - step);
    };
    return { along(1.0f, 0.0f, 0.0f), along(0.0f, 1.0f, 0.0f), along(0.0f, 0.0f, 1.0f) };
  }

  /// For ExtremeMarch: the value of a box. A box that a ray merely touches is ignored: rounding may
  /// find one where the ray begins or ends.
  Lanes BetterOf(const PacketRays& rays, const LatticePlace& place, Lanes exit, float sense,
    Lanes found, LaneMask mask) const
  {
    constexpr float ShortestVoxels = 2e-5f;
    const LaneMask isSeen =
      mask & LaneMask((exit - place.t) * Length(rays.directionGrid) > ShortestVoxels);
    return Select(isSeen, Max(found, sense * this->ValueOf(place.cell)), found);
  }

private:
  IntLanes WithinAxis(Lanes voxel, int axis) const
  {
    return Truncated(Clamp(voxel, Lanes{}, All(float(this->count[axis] - 1))));
  }

  BoxValues<Content> values;
  glm::ivec3 count;
};

/// Marches from face to face: each box is read once, and its integral is exact.
/// @param take  (sum, voxel, its value, t where the rays enter it, length of the rays in it [mm], 0
///              for a ray that has ended)
template <class Voxel, class Take>
PacketSum MarchBoxes(const PacketScene& scene, const PacketRays& rays, const PacketWalk& walk,
  const PacketSum& before, const PacketBoxes<Voxel>& boxes, Take take)
{
  constexpr float VoxelsPerSegment = 4.0f;
  const Lanes segmentMm = VoxelsPerSegment / Length(rays.directionGrid);
  const PacketLattice lattice = boxes.LatticeOf(rays);
  PacketSum sum = before;
  LatticePlace place = lattice.At(rays.enter);
  LaneMask going = GoOn(scene, rays, place.t, sum);
  for (int index = 0; index < scene.rays.mostSegments && Any(going); ++index)
  {
    const SegmentLanes segment = walk.NextOfBricks(place.t, segmentMm, going);
    const LaneMask jumps = going & LaneMask(segment.enter > place.t);
    place = Select(jumps, lattice.At(segment.enter), place);
    going &= LaneMask(place.t < rays.exit);
    for (LaneMask inside = going; Any(inside);
         inside &= LaneMask(place.t < segment.exit) & GoOn(scene, rays, place.t, sum))
    {
      const LatticePlace behind = lattice.Behind(place);
      const Lanes value = boxes.ValueOf(place.cell);
      const LaneMask absorbs = inside & MayAbsorb(scene.look, value, value);
      if (Any(absorbs))
      {
        const Lanes lengthMm = Select(absorbs, Min(behind.t, rays.exit) - place.t, Lanes{});
        take(sum, place.cell, value, place.t, lengthMm);
      }
      place = Select(inside, behind, place);
    }
    going &= GoOn(scene, rays, place.t, sum);
  }
  return sum;
}

template <class Voxel>
PacketSum MarchBoxValues(
  const PacketScene& scene, const PacketRays& rays, const PacketWalk& walk, const PacketSum& before)
{
  return MarchBoxes(scene, rays, walk, before, PacketBoxes<Voxel>(scene.volume),
    [&](PacketSum& sum, const Lanes3&, Lanes value, Lanes, Lanes lengthMm)
    { sum.Add(Classify(scene.look, value), lengthMm); });
}

}

}

#endif
