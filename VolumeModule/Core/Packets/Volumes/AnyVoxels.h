#ifndef Varimarch_Core_Packets_Volumes_AnyVoxels_h
#define Varimarch_Core_Packets_Volumes_AnyVoxels_h

// The voxels of a constituent of a mixture, whatever their type and spacing.

#include "Core/Packets/Interpolation/CubicSpline.h"
#include "Core/Packets/Interpolation/Linear.h"
#include "Core/Packets/March/Voxels.h"
#include "Core/Packets/Spacing/Uneven.h"

namespace varimarch
{

namespace
{

/// Calls a function with a reader for the type of the voxels.
/// @param read  (reader)
template <template <class> class Reader, class Read>
auto ReadByType(const PacketVolume& volume, Read read)
{
  return ByVoxelType(
    volume.type, [&](auto voxel) { return read(Reader<decltype(voxel)>(volume)); });
}

/// The place where voxels are read.
inline Lanes3 VoxelPlace(const PacketScene& scene, const Lanes3& grid)
{
  return scene.textures.spacingTable ? UnevenPlace(scene, grid) : grid;
}

/// The slope along the axes of the even grid, in which rays are straight.
template <class Voxels>
Slope EvenSlopeAt(const PacketScene& scene, const Voxels& voxels, const Lanes3& grid, LaneMask mask)
{
  if (!scene.textures.spacingTable)
  {
    return voxels.SlopeAt(grid, mask);
  }
  const auto along = [&](float x, float y, float z)
  {
    const Lanes3 step{ All(x), All(y), All(z) };
    return voxels.ValueAt(VoxelPlace(scene, grid + step)) -
      voxels.ValueAt(VoxelPlace(scene, grid - step));
  };
  return { voxels.ValueAt(VoxelPlace(scene, grid)),
    { along(1.0f, 0.0f, 0.0f), along(0.0f, 1.0f, 0.0f), along(0.0f, 0.0f, 1.0f) } };
}

/// Rays to lights read voxels one place at a time, so that finding their type again at each costs
/// little, and these rays are compiled once instead of for each type. For voxels without
/// interpolation see AnyBoxes.
class AnyVoxels
{
public:
  explicit AnyVoxels(const PacketScene& scene)
    : scene(scene)
  {
  }

  [[gnu::noinline]] Lanes ValueAt(const Lanes3& positionGrid) const
  {
    const PacketVolume& volume = this->scene.volume;
    const Lanes3 place = VoxelPlace(this->scene, positionGrid);
    return volume.areOfSpline
      ? PacketSpline(volume).ValueAt(place)
      : ReadByType<PacketVoxels>(volume, [&](const auto& voxels) { return voxels.ValueAt(place); });
  }

  [[gnu::noinline]] Slope SlopeAt(const Lanes3& positionGrid, LaneMask mask) const
  {
    const PacketVolume& volume = this->scene.volume;
    return volume.areOfSpline
      ? EvenSlopeAt(this->scene, PacketSpline(volume), positionGrid, mask)
      : ReadByType<PacketVoxels>(volume,
          [&](const auto& voxels) { return EvenSlopeAt(this->scene, voxels, positionGrid, mask); });
  }

private:
  const PacketScene& scene;
};

/// The same for voxels without interpolation, read like PacketBoxes.
class AnyBoxes
{
public:
  explicit AnyBoxes(const PacketScene& scene)
    : volume(scene.volume)
  {
  }

  PacketLattice LatticeOf(const PacketRays& rays) const
  {
    return PacketLattice(rays, 1.0f, -0.5f, this->volume.voxelCount);
  }

  [[gnu::noinline]] Lanes ValueOf(const Lanes3& voxel) const
  {
    return ReadByType<PacketBoxes>(
      this->volume, [&](const auto& boxes) { return boxes.ValueOf(voxel); });
  }

  [[gnu::noinline]] Lanes3 GradientOf(const Lanes3& voxel) const
  {
    return ReadByType<PacketBoxes>(
      this->volume, [&](const auto& boxes) { return boxes.GradientOf(voxel); });
  }

private:
  const PacketVolume& volume;
};

}

}

#endif
