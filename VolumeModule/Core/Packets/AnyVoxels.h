#ifndef Varimarch_Core_Packets_AnyVoxels_h
#define Varimarch_Core_Packets_AnyVoxels_h

// Voxels of any type, number, spacing and interpolation. Their kind is found again at each read, so
// that a march through them is compiled once instead of for each type.
// Twin of Interpolation/CubicSpline.glsl, Gradient/OfSpline.glsl, Gradient/OfSplines.glsl and
// Spacing/Uneven.glsl.

#include "Core/Packets/Lanes.h"
#include "Core/Packets/PacketScene.h"
#include "Core/Packets/ShaderMath.h"
#include "Core/Packets/Voxels.h"

#include <cstddef>

namespace varimarch
{

namespace
{

/// The weights of the four coefficients along an axis that a value, or its derivative, depends on.
struct AxisWeights
{
  Lanes of[4];
};

inline AxisWeights AlongX(const SplineWeights& w)
{
  return { { w.first.x, w.second.x, w.third.x, w.last.x } };
}

inline AxisWeights AlongY(const SplineWeights& w)
{
  return { { w.first.y, w.second.y, w.third.y, w.last.y } };
}

inline AxisWeights AlongZ(const SplineWeights& w)
{
  return { { w.first.z, w.second.z, w.third.z, w.last.z } };
}

/// Gives the weight of a coefficient beyond the outermost ones to that of the face.
/// @param beyond  -1 if one is before the first, 1 if one is behind the last, else 0
inline AxisWeights MovedInside(const AxisWeights& weights, Lanes beyond)
{
  const Lanes(&w)[4] = weights.of;
  const LaneMask before = LaneMask(beyond < 0.0f);
  const LaneMask behind = LaneMask(beyond > 0.0f);
  const auto choose = [&](Lanes ifBefore, Lanes ifBehind, Lanes inside)
  { return Select(before, ifBefore, Select(behind, ifBehind, inside)); };
  return { { choose(w[0] + w[1], Lanes{}, w[0]), choose(w[2], w[0], w[1]), choose(w[3], w[1], w[2]),
    choose(Lanes{}, w[2] + w[3], w[3]) } };
}

/// The lanes in memory.
struct SplineNumbers
{
  explicit SplineNumbers(const AxisWeights& weights)
    : of{ Numbers(weights.of[0]), Numbers(weights.of[1]), Numbers(weights.of[2]),
      Numbers(weights.of[3]) }
  {
  }

  float At(int which, int lane) const { return this->of[which].of[lane]; }

  Numbers of[4];
};

/// The spline, read in the same way as PacketVoxels.
class PacketSpline
{
public:
  /// 4 x 4 x 4 coefficients, and the place of a position in the middle one of their cells.
  struct Cell
  {
    IntNumbers index; ///< index of the first coefficient
    Lanes3 part;      ///< [0, 1]
    Lanes3 beyond;    ///< see MovedInside
  };

  explicit PacketSpline(const VoxelsInMemory& coefficients)
    : coefficients(coefficients)
  {
  }

  Cell CellOf(const Lanes3& positionGrid) const
  {
    const AxisPlace x = PlaceOn(positionGrid.x, this->coefficients.lastVoxel.x);
    const AxisPlace y = PlaceOn(positionGrid.y, this->coefficients.lastVoxel.y);
    const AxisPlace z = PlaceOn(positionGrid.z, this->coefficients.lastVoxel.z);
    return { this->coefficients.IndexOf<IntNumbers>(
               Truncated(x.first), Truncated(y.first), Truncated(z.first)),
      { x.part, y.part, z.part }, { x.beyond, y.beyond, z.beyond } };
  }

  Lanes ValueIn(const Cell& cell) const
  {
    const SplineWeights weights = WeightsOfValue(cell.part);
    const SplineNumbers alongY(MovedInside(AlongY(weights), cell.beyond.y));
    const SplineNumbers alongZ(MovedInside(AlongZ(weights), cell.beyond.z));
    Four sums[LaneCount];
    for (int lane = 0; lane < LaneCount; ++lane)
    {
      sums[lane] = Four{};
      for (int slice = 0; slice < 4; ++slice)
      {
        sums[lane] = MultiplyAdd(
          alongZ.At(slice, lane), this->SumOfRows(cell, slice, alongY, lane), sums[lane]);
      }
    }
    return SumAlongX(sums, MovedInside(AlongX(weights), cell.beyond.x));
  }

  Lanes ValueAt(const Lanes3& positionGrid) const
  {
    return this->ValueIn(this->CellOf(positionGrid));
  }

  /// Its gradient is twice the derivatives: everything that uses gradients expects differences over
  /// two voxels.
  Slope SlopeAt(const Lanes3& positionGrid, LaneMask) const
  {
    const Cell cell = this->CellOf(positionGrid);
    const SplineWeights ofValue = WeightsOfValue(cell.part);
    const SplineWeights ofSlope = WeightsOfSlope(cell.part);
    const SplineNumbers valueY(MovedInside(AlongY(ofValue), cell.beyond.y));
    const SplineNumbers slopeY(MovedInside(AlongY(ofSlope), cell.beyond.y));
    const SplineNumbers valueZ(MovedInside(AlongZ(ofValue), cell.beyond.z));
    const SplineNumbers slopeZ(MovedInside(AlongZ(ofSlope), cell.beyond.z));
    Four values[LaneCount];
    Four slopesY[LaneCount];
    Four slopesZ[LaneCount];
    for (int lane = 0; lane < LaneCount; ++lane)
    {
      values[lane] = slopesY[lane] = slopesZ[lane] = Four{};
      for (int slice = 0; slice < 4; ++slice)
      {
        const Four value = this->SumOfRows(cell, slice, valueY, lane);
        const Four slope = this->SumOfRows(cell, slice, slopeY, lane);
        values[lane] = MultiplyAdd(valueZ.At(slice, lane), value, values[lane]);
        slopesY[lane] = MultiplyAdd(valueZ.At(slice, lane), slope, slopesY[lane]);
        slopesZ[lane] = MultiplyAdd(slopeZ.At(slice, lane), value, slopesZ[lane]);
      }
    }
    const AxisWeights valueX = MovedInside(AlongX(ofValue), cell.beyond.x);
    const Lanes value = SumAlongX(values, valueX);
    const Lanes3 slope{ SumAlongX(values, MovedInside(AlongX(ofSlope), cell.beyond.x)),
      SumAlongX(slopesY, valueX), SumAlongX(slopesZ, valueX) };
    return { value,
      { 2.0f * SlopeBeyondRounding(value, slope.x), 2.0f * SlopeBeyondRounding(value, slope.y),
        2.0f * SlopeBeyondRounding(value, slope.z) } };
  }

private:
  // The four coefficients that a value depends on along an axis.
  struct AxisPlace
  {
    Lanes first; ///< a whole number
    Lanes part;
    Lanes beyond;
  };

  static AxisPlace PlaceOn(Lanes position, Lanes lastVoxel)
  {
    const Lanes inside = Clamp(position, Lanes{}, lastVoxel);
    const Lanes second = Floor(Min(inside, lastVoxel - 1.0f));
    const Lanes wanted = second - 1.0f;
    const Lanes first = Clamp(wanted, Lanes{}, lastVoxel - 3.0f);
    return { first, inside - second, wanted - first };
  }

  // The sum of the four rows in a slice of a cell, for one lane.
  Four SumOfRows(const Cell& cell, int slice, const SplineNumbers& weights, int lane) const
  {
    const float* const row = static_cast<const float*>(this->coefficients.first) +
      cell.index.of[lane] + slice * this->coefficients.perSlice;
    Four sum = weights.At(0, lane) * FourAt(row);
    for (int i = 1; i < 4; ++i)
    {
      sum = MultiplyAdd(weights.At(i, lane), FourAt(row + i * this->coefficients.perRow), sum);
    }
    return sum;
  }

  static Lanes SumAlongX(const Four (&sums)[LaneCount], const AxisWeights& weights)
  {
    const Lanes4 along = Transposed(sums);
    return weights.of[0] * along.x + weights.of[1] * along.y + weights.of[2] * along.z +
      weights.of[3] * along.w;
  }

  VoxelsInMemory coefficients;
};

/// The places in the grid of the voxels for places in the even grid, in which rays are straight.
inline Lanes3 UnevenPlace(const PacketScene& scene, const Lanes3& grid)
{
  const VolumeParameters& p = scene.parameters;
  const auto along = [&](Lanes place, int axis)
  {
    const Lanes bin = SpacingBin(place, All(p.spacingLowerGrid[axis]),
      All(p.spacingBinsPerGrid[axis]), All(p.spacingFirstBins[axis]), All(p.spacingLastBins[axis]));
    const IntNumbers index(Truncated(bin));
    Four pieces[LaneCount];
    for (int lane = 0; lane < LaneCount; ++lane)
    {
      pieces[lane] = FourAt(&scene.textures.spacingTable[index.of[lane]].x);
    }
    return UnevenPlace(place, Transposed(pieces));
  };
  return { along(grid.x, 0), along(grid.y, 1), along(grid.z, 2) };
}

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
