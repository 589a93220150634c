#ifndef Varimarch_Core_Packets_Interpolation_AnyVoxels_h
#define Varimarch_Core_Packets_Interpolation_AnyVoxels_h

// Voxels of any type, number, spacing and interpolation. Their kind is found again at each read, so
// that a march through them is compiled once instead of for each type.

#include "Core/Packets/Flattened.h"
#include "Core/Packets/Interpolation/CubicSpline.h"
#include "Core/Packets/Interpolation/Linear.h"
#include "Core/Packets/Interpolation/Nearest.h"
#include "Core/Packets/Spacing/Uneven.h"

namespace varimarch
{

namespace
{

/// The place where voxels are read.
inline Lanes3 VoxelPlace(const PacketScene& scene, const Lanes3& grid)
{
  return scene.textures.spacingTable ? UnevenPlace(scene, grid) : grid;
}

/// Voxels, interpolated as the scene says. Places and slopes are those of the even grid, in which
/// rays are straight.
class AnyVoxels
{
  template <class Call>
  auto ReadLinear(Call call) const
  {
    return ByVoxelType(this->scene.volume.type,
      [&](auto voxel)
      {
        using Voxel = decltype(voxel);
        return this->areFew ? call(PacketVoxels<Voxel>(this->voxels))
                            : call(PacketVoxels<Voxel, WideNumbers>(this->voxels));
      });
  }

  template <class Call>
  auto Read(Call call) const
  {
    return this->scene.volume.areOfSpline ? call(PacketSpline(this->voxels))
                                          : this->ReadLinear(call);
  }

public:
  explicit AnyVoxels(const PacketScene& scene)
    : AnyVoxels(scene, scene.volume.voxels)
  {
  }

  /// @param first  the first voxel of another component of the same volume
  AnyVoxels(const PacketScene& scene, const void* first)
    : scene(scene)
    , voxels(scene.volume)
    , areFew(IsIndexedBy32Bits(scene.volume.voxelCount))
  {
    this->voxels.first = first;
  }

  /// True if PacketVoxels of the type read the same.
  static bool AreOfOneType(const PacketScene& scene)
  {
    return IsIndexedBy32Bits(scene.volume.voxelCount) && !scene.volume.areOfSpline &&
      !scene.textures.spacingTable;
  }

  [[gnu::noinline]] FLATTENED Lanes ValueAt(const Lanes3& grid) const
  {
    const Lanes3 place = VoxelPlace(this->scene, grid);
    return this->Read([&](const auto& typed) { return typed.ValueAt(place); });
  }

  /// @param mask  the rays whose gradient matters
  [[gnu::noinline]] FLATTENED Slope SlopeAt(const Lanes3& grid, LaneMask mask) const
  {
    return this->scene.textures.spacingTable
      ? this->UnevenSlopeAt(grid)
      : this->Read([&](const auto& typed) { return typed.SlopeAt(grid, mask); });
  }

  [[gnu::noinline]] FLATTENED CellCorners CornersOf(const Lanes3& cellGrid) const
  {
    return this->ReadLinear([&](const auto& typed) { return typed.CornersOf(cellGrid); });
  }

  /// The values at several places.
  template <int Count>
  [[gnu::noinline]] FLATTENED void ReadAll(
    const Lanes3 (&grid)[Count], Lanes (&values)[Count]) const
  {
    const auto placeOf = [&](int i) { return VoxelPlace(this->scene, grid[i]); };
    this->Read([&](const auto& typed) { ReadCells(typed, placeOf, values); });
  }

private:
  Slope UnevenSlopeAt(const Lanes3& grid) const
  {
    const auto along = [&](float x, float y, float z)
    {
      const Lanes3 step{ All(x), All(y), All(z) };
      return this->ValueAt(grid + step) - this->ValueAt(grid - step);
    };
    return { this->ValueAt(grid),
      { along(1.0f, 0.0f, 0.0f), along(0.0f, 1.0f, 0.0f), along(0.0f, 0.0f, 1.0f) } };
  }

  const PacketScene& scene;
  VoxelsInMemory voxels;
  bool areFew; ///< true if 32 bits can number them
};

template <int Count>
void ReadValues(
  const AnyVoxels& voxels, const PacketRays& rays, Lanes first, Lanes apart, Lanes (&values)[Count])
{
  Lanes3 places[Count];
  for (int i = 0; i < Count; ++i)
  {
    places[i] = rays.At(first + float(i) * apart);
  }
  voxels.ReadAll(places, values);
}

/// Voxels without interpolation.
class AnyBoxes
{
  template <class Call>
  auto Read(Call call) const
  {
    return ByVoxelType(this->volume.type,
      [&](auto voxel)
      {
        using Voxel = decltype(voxel);
        return this->areFew ? call(PacketBoxes<Voxel>(this->volume))
                            : call(PacketBoxes<Voxel, WideNumbers>(this->volume));
      });
  }

public:
  explicit AnyBoxes(const PacketScene& scene)
    : AnyBoxes(scene, scene.volume.voxels)
  {
  }

  /// @param first  the first voxel of another component of the same volume
  AnyBoxes(const PacketScene& scene, const void* first)
    : volume(scene.volume)
    , areFew(IsIndexedBy32Bits(scene.volume.voxelCount))
  {
    this->volume.voxels = first;
  }

  PacketLattice LatticeOf(const PacketRays& rays) const
  {
    return LatticeOfBoxes(rays, this->volume.voxelCount);
  }

  [[gnu::noinline]] FLATTENED Lanes ValueOf(const Lanes3& voxel) const
  {
    return this->Read([&](const auto& typed) { return typed.ValueOf(voxel); });
  }

  Lanes ValueAt(const Lanes3& placeGrid) const { return this->ValueOf(BoxAt(placeGrid)); }

  [[gnu::noinline]] FLATTENED Lanes3 GradientOf(const Lanes3& voxel) const
  {
    return this->Read([&](const auto& typed) { return typed.GradientOf(voxel); });
  }

private:
  PacketVolume volume;
  bool areFew; ///< true if 32 bits can number them
};

}

}

#endif
