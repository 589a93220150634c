#ifndef Varimarch_Core_Packets_Interpolation_Nearest_h
#define Varimarch_Core_Packets_Interpolation_Nearest_h

// Voxels without interpolation: boxes of one value, which extend half a voxel to every side.

#include "Core/Packets/Interpolation/Linear.h"
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

/// The boxes, as the cells of a lattice.
inline PacketLattice LatticeOfBoxes(const PacketRays& rays, const glm::ivec3& count)
{
  return PacketLattice(rays, 1.0f, -0.5f, count);
}

/// The box that contains a place.
inline Lanes3 BoxAt(const Lanes3& placeGrid)
{
  return Floor(placeGrid + 0.5f);
}

/// Boxes of voxels of one type. The outermost ones extend beyond the volume.
/// @tparam Indices  see VoxelsInMemory
template <class Voxel, class Indices = IntNumbers>
class PacketBoxes
{
public:
  explicit PacketBoxes(const PacketScene& scene)
    : PacketBoxes(scene.volume)
  {
  }

  explicit PacketBoxes(const PacketVolume& volume)
    : voxels(volume)
    , count(volume.voxelCount)
  {
  }

  PacketLattice LatticeOf(const PacketRays& rays) const
  {
    return LatticeOfBoxes(rays, this->count);
  }

  Lanes ValueOf(const Lanes3& voxel) const
  {
    return ValuesAt(static_cast<const Voxel*>(this->voxels.first),
      this->voxels.template IndexOf<Indices>(
        this->WithinAxis(voxel.x, 0), this->WithinAxis(voxel.y, 1), this->WithinAxis(voxel.z, 2)));
  }

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

private:
  IntLanes WithinAxis(Lanes voxel, int axis) const
  {
    return Truncated(Clamp(voxel, Lanes{}, All(float(this->count[axis] - 1))));
  }

  VoxelsInMemory voxels;
  glm::ivec3 count;
};

}

}

#endif
