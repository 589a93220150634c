#ifndef Varimarch_Core_Packets_Voxels_h
#define Varimarch_Core_Packets_Voxels_h

// Voxels of one type: interpolated between them, as boxes without interpolation, and the cubics
// along lines through the cells between them.
// Twin of Interpolation/Linear.glsl, Gradient/CentralDifferences.glsl and
// Gradient/CentralDifferencesOfAll.glsl.

#include "Core/Packets/PacketScene.h"
#include "Core/Packets/ShaderMath.h"
#include "Core/Packets/Walk.h"

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace varimarch
{

namespace
{

/// Voxels in memory, whatever their type.
struct VoxelsInMemory
{
  const void* first;
  std::ptrdiff_t perRow;
  std::ptrdiff_t perSlice;
  Lanes3 lastVoxel;
  bool hasInnerCells; ///< true if there are cells with voxels on all sides

  explicit VoxelsInMemory(const PacketVolume& volume)
    : first(volume.voxels)
    , perRow(volume.voxelCount.x)
    , perSlice(std::ptrdiff_t(volume.voxelCount.x) * volume.voxelCount.y)
    , lastVoxel{ All(float(volume.voxelCount.x - 1)), All(float(volume.voxelCount.y - 1)),
      All(float(volume.voxelCount.z - 1)) }
    , hasInnerCells(
        volume.voxelCount.x >= 4 && volume.voxelCount.y >= 4 && volume.voxelCount.z >= 4)
  {
  }

  /// @tparam Indices  IntNumbers for fewer than 2^31 voxels, WideNumbers for any number
  template <class Indices>
  Indices IndexOf(IntLanes x, IntLanes y, IntLanes z) const
  {
    if constexpr (std::is_same_v<Indices, IntNumbers>)
    {
      return IntNumbers(x + int(this->perRow) * y + int(this->perSlice) * z);
    }
    else
    {
      Indices index;
      for (int lane = 0; lane < LaneCount; ++lane)
      {
        index.of[lane] = x[lane] + this->perRow * y[lane] + this->perSlice * z[lane];
      }
      return index;
    }
  }
};

/// Two values for each lane that follow each other along x.
struct ValuePairs
{
  Lanes first;
  Lanes second;
};

/// A pair of voxels in memory, as one number of the same size.
template <class Bits, class Voxel>
Bits PairAt(const Voxel* first)
{
  static_assert(sizeof(Bits) == 2 * sizeof(Voxel));
  Bits bits;
  __builtin_memcpy(&bits, first, sizeof bits);
  return bits;
}

/// The values of pairs of 8 or 16 bit voxels, which are in the lower bits of each lane.
template <class Voxel>
ValuePairs UnpackedPairs(IntLanes bits)
{
  constexpr int width = 8 * sizeof(Voxel);
  constexpr int unused = 32 - 2 * width;
  if constexpr (Voxel(-1) < Voxel(0))
  {
    return { FloatOf(bits << (unused + width) >> (32 - width)),
      FloatOf(bits << unused >> (32 - width)) };
  }
  constexpr int all = (1 << width) - 1;
  return { FloatOf(bits & all), FloatOf(bits >> width & all) };
}

/// @param index  index of the first voxel of each pair, counted from `base`
template <class Voxel, class Indices>
ValuePairs PairsAt(const Voxel* base, const Indices& index)
{
  if constexpr (sizeof(Voxel) == 1)
  {
    return UnpackedPairs<Voxel>(
      WidenedLanes([&](int lane) { return PairAt<std::uint16_t>(base + index.of[lane]); }));
  }
  else if constexpr (sizeof(Voxel) == 2)
  {
    return UnpackedPairs<Voxel>(
      IntLanesOf([&](int lane) { return PairAt<std::int32_t>(base + index.of[lane]); }));
  }
  else
  {
    const auto pair = [&](int lane) { return PairAt<double>(base + index.of[lane]); };
    const Lanes pairs = PairsInBothHalves(pair, 0);
    const Lanes nextPairs = PairsInBothHalves(pair, 2);
    return { EvenNumbers(pairs, nextPairs), OddNumbers(pairs, nextPairs) };
  }
}

/// A cell, and its eight voxels.
struct CellCorners
{
  ValuePairs rows[2][2]; ///< [slice][row]
  Lanes3 cellGrid;       ///< the first voxel

  /// The place of a position in the cell, [0, 1] on each axis: positions outside are moved in.
  Lanes3 Inside(const Lanes3& positionGrid) const
  {
    const Lanes3 part = positionGrid - this->cellGrid;
    return { Clamp(part.x, Lanes{}, All(1.0f)), Clamp(part.y, Lanes{}, All(1.0f)),
      Clamp(part.z, Lanes{}, All(1.0f)) };
  }
};

/// A value, and the differences between the values one voxel to either side.
struct Slope
{
  Lanes value;
  Lanes3 gradient;
};

/// Trilinear interpolation between voxels of one type. The outermost ones extend beyond the volume.
/// @tparam Indices  see VoxelsInMemory
template <class Voxel, class Indices = IntNumbers>
class PacketVoxels
{
public:
  struct Cell
  {
    Indices index; ///< index of its first voxel
    Lanes3 part;   ///< how far into it, [0, 1]
  };

  explicit PacketVoxels(const PacketScene& scene)
    : voxels(scene.volume)
  {
  }

  explicit PacketVoxels(const VoxelsInMemory& voxels)
    : voxels(voxels)
  {
  }

  Cell CellOf(const Lanes3& positionGrid) const
  {
    return this->CellAt(this->Inside(positionGrid, Lanes{}), Lanes{});
  }

  Lanes ValueIn(const Cell& cell) const
  {
    return Mix(Mix(this->AlongRow(cell, 0, 0), this->AlongRow(cell, 1, 0), cell.part.y),
      Mix(this->AlongRow(cell, 0, 1), this->AlongRow(cell, 1, 1), cell.part.y), cell.part.z);
  }

  Lanes ValueAt(const Lanes3& positionGrid) const
  {
    return this->ValueIn(this->CellOf(positionGrid));
  }

  /// @param mask  the rays whose gradient matters
  Slope SlopeAt(const Lanes3& positionGrid, LaneMask mask) const
  {
    const Lanes one = All(1.0f);
    const Lanes3 inner = this->Inside(positionGrid, one);
    const LaneMask isOutside = LaneMask(inner.x != positionGrid.x) |
      LaneMask(inner.y != positionGrid.y) | LaneMask(inner.z != positionGrid.z);
    if (this->voxels.hasInnerCells && !Any(mask & isOutside))
    {
      return this->SlopeIn(this->CellAt(inner, one));
    }
    const auto along = [&](int x, int y, int z)
    {
      return this->ValueBeside(positionGrid, { x, y, z }) -
        this->ValueBeside(positionGrid, { -x, -y, -z });
    };
    return { this->ValueAt(positionGrid), { along(1, 0, 0), along(0, 1, 0), along(0, 0, 1) } };
  }

  /// @param cellGrid  the first voxel; if it is outside, the nearest cell is read
  CellCorners CornersOf(const Lanes3& cellGrid) const
  {
    const Lanes one = All(1.0f);
    const Lanes3 cell{ Clamp(cellGrid.x, Lanes{}, this->voxels.lastVoxel.x - one),
      Clamp(cellGrid.y, Lanes{}, this->voxels.lastVoxel.y - one),
      Clamp(cellGrid.z, Lanes{}, this->voxels.lastVoxel.z - one) };
    const Indices index = this->IndexOf(Truncated(cell.x), Truncated(cell.y), Truncated(cell.z));
    return { { { this->PairsIn(index, 0, 0, 0), this->PairsIn(index, 0, 1, 0) },
               { this->PairsIn(index, 0, 0, 1), this->PairsIn(index, 0, 1, 1) } },
      cell };
  }

private:
  // The nearest position at least `border` voxels from the outermost ones.
  Lanes3 Inside(const Lanes3& positionGrid, Lanes border) const
  {
    return { Clamp(positionGrid.x, border, this->voxels.lastVoxel.x - border),
      Clamp(positionGrid.y, border, this->voxels.lastVoxel.y - border),
      Clamp(positionGrid.z, border, this->voxels.lastVoxel.z - border) };
  }

  // The last plane of voxels inside is the end of the last cell.
  Cell CellAt(const Lanes3& inside, Lanes border) const
  {
    const Lanes beforeLast = border + 1.0f;
    const IntLanes x = Truncated(Min(inside.x, this->voxels.lastVoxel.x - beforeLast));
    const IntLanes y = Truncated(Min(inside.y, this->voxels.lastVoxel.y - beforeLast));
    const IntLanes z = Truncated(Min(inside.z, this->voxels.lastVoxel.z - beforeLast));
    return { this->IndexOf(x, y, z),
      { inside.x - FloatOf(x), inside.y - FloatOf(y), inside.z - FloatOf(z) } };
  }

  struct AxisCell
  {
    IntLanes first;
    Lanes part;
  };

  // The cell some voxels beside that of a position. The part is that of the position itself unless
  // a face is nearer: the same voxels on both sides of it then have no difference, not even one of
  // rounding.
  static AxisCell CellBeside(Lanes position, int voxels, Lanes lastVoxel)
  {
    const Lanes whole = Floor(position);
    const Lanes first = whole + float(voxels);
    const Lanes last = lastVoxel - 1.0f;
    return { Truncated(Min(Max(first, Lanes{}), last)),
      Select(LaneMask(first < 0.0f), Lanes{},
        Select(LaneMask(first > last), All(1.0f), position - whole)) };
  }

  Lanes ValueBeside(const Lanes3& positionGrid, const glm::ivec3& voxels) const
  {
    const AxisCell x = CellBeside(positionGrid.x, voxels.x, this->voxels.lastVoxel.x);
    const AxisCell y = CellBeside(positionGrid.y, voxels.y, this->voxels.lastVoxel.y);
    const AxisCell z = CellBeside(positionGrid.z, voxels.z, this->voxels.lastVoxel.z);
    return this->ValueIn({ this->IndexOf(x.first, y.first, z.first), { x.part, y.part, z.part } });
  }

  // Pairs of voxels at this offset from the first voxel of each cell, in voxels, rows and slices.
  ValuePairs PairsIn(const Indices& index, int x, int rows, int slices) const
  {
    return PairsAt(static_cast<const Voxel*>(this->voxels.first) +
        (x + rows * this->voxels.perRow + slices * this->voxels.perSlice),
      index);
  }

  ValuePairs RowOf(const Cell& cell, int x, int rows, int slices) const
  {
    return this->PairsIn(cell.index, x, rows, slices);
  }

  Lanes AlongRow(const Cell& cell, int rows, int slices) const
  {
    const ValuePairs pair = this->RowOf(cell, 0, rows, slices);
    return Mix(pair.first, pair.second, cell.part.x);
  }

  // A row of the cell: the value between its two voxels, and the difference between the values one
  // voxel behind and one before.
  struct RowSlope
  {
    Lanes value;
    Lanes slope;
  };

  RowSlope RowSlopeOf(const Cell& cell, int rows, int slices) const
  {
    const ValuePairs before = this->RowOf(cell, -1, rows, slices);
    const ValuePairs behind = this->RowOf(cell, 1, rows, slices);
    return { Mix(before.second, behind.first, cell.part.x),
      Mix(behind.first, behind.second, cell.part.x) -
        Mix(before.first, before.second, cell.part.x) };
  }

  // Reads each of the voxels once between which seven values are interpolated.
  Slope SlopeIn(const Cell& cell) const
  {
    const Lanes3& part = cell.part;
    const RowSlope rows[2][2] = { { this->RowSlopeOf(cell, 0, 0), this->RowSlopeOf(cell, 1, 0) },
      { this->RowSlopeOf(cell, 0, 1), this->RowSlopeOf(cell, 1, 1) } }; // [slice][row]
    Lanes alongY[2];
    for (int slice = 0; slice < 2; ++slice)
    {
      alongY[slice] = Mix(rows[slice][1].value, this->AlongRow(cell, 2, slice), part.y) -
        Mix(this->AlongRow(cell, -1, slice), rows[slice][0].value, part.y);
    }
    Lanes alongZ[2];
    for (int row = 0; row < 2; ++row)
    {
      alongZ[row] = Mix(rows[1][row].value, this->AlongRow(cell, row, 2), part.z) -
        Mix(this->AlongRow(cell, row, -1), rows[0][row].value, part.z);
    }
    const Lanes front = Mix(rows[0][0].slope, rows[0][1].slope, part.y);
    const Lanes back = Mix(rows[1][0].slope, rows[1][1].slope, part.y);
    const Lanes value = Mix(Mix(rows[0][0].value, rows[0][1].value, part.y),
      Mix(rows[1][0].value, rows[1][1].value, part.y), part.z);
    return { value,
      { Mix(front, back, part.z), Mix(alongY[0], alongY[1], part.z),
        Mix(alongZ[0], alongZ[1], part.y) } };
  }

  Indices IndexOf(IntLanes x, IntLanes y, IntLanes z) const
  {
    return this->voxels.template IndexOf<Indices>(x, y, z);
  }

  VoxelsInMemory voxels;
};

/// Reads the values at places. All cells are found before any is read, and all are read before any
/// is classified, so that no read waits for another.
/// @param placeOf  (index) -> place in the grid of the voxels
template <class Voxels, class PlaceOf, int Count>
void ReadCells(const Voxels& voxels, PlaceOf placeOf, Lanes (&values)[Count])
{
  typename Voxels::Cell cells[Count];
  for (int i = 0; i < Count; ++i)
  {
    cells[i] = voxels.CellOf(placeOf(i));
  }
  for (int i = 0; i < Count; ++i)
  {
    values[i] = voxels.ValueIn(cells[i]);
  }
}

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

// The interpolated values along a line through a cell, which are exactly a cubic: see
// Core/Geometry/CellCubic.h and Shaders/Math/CellCubic.glsl.

/// The cubics along lines, each of which lies in one cell. The coefficients follow from the values
/// at the corners of the box between the ends of a line.
/// @param enterGrid, leaveGrid  the ends
inline Lanes4 CubicBetween(
  const CellCorners& corners, const Lanes3& enterGrid, const Lanes3& leaveGrid)
{
  const Lanes3 enter = corners.Inside(enterGrid);
  const Lanes3 leave = corners.Inside(leaveGrid);
  Lanes edges[2][2][2]; // [slice][row][end along x]
  Lanes faces[2][2][2]; // [slice][end along y][end along x]
  for (int slice = 0; slice < 2; ++slice)
  {
    for (int row = 0; row < 2; ++row)
    {
      const ValuePairs& pair = corners.rows[slice][row];
      edges[slice][row][0] = Mix(pair.first, pair.second, enter.x);
      edges[slice][row][1] = Mix(pair.first, pair.second, leave.x);
    }
    for (int x = 0; x < 2; ++x)
    {
      faces[slice][0][x] = Mix(edges[slice][0][x], edges[slice][1][x], enter.y);
      faces[slice][1][x] = Mix(edges[slice][0][x], edges[slice][1][x], leave.y);
    }
  }
  const auto atEnter = [&](int y, int x) { return Mix(faces[0][y][x], faces[1][y][x], enter.z); };
  const auto atLeave = [&](int y, int x) { return Mix(faces[0][y][x], faces[1][y][x], leave.z); };
  constexpr float Third = 1.0f / 3.0f;
  return { atEnter(0, 0), Third * (atEnter(0, 1) + atEnter(1, 0) + atLeave(0, 0)),
    Third * (atEnter(1, 1) + atLeave(0, 1) + atLeave(1, 0)), atLeave(1, 1) };
}

/// A part of a cubic on which it is monotone.
struct MonotonePiece
{
  Lanes begin; ///< [0, 1]
  Lanes end;
};

/// The place where a cubic takes a value that lies between its values at the ends of a piece: by
/// Newton's method, and by bisection where that leads outside.
/// @param mask  the rays for which it matters
inline Lanes CrossingOf(const Lanes4& cubic, Lanes value, MonotonePiece piece, LaneMask mask)
{
  const LaneMask falls = LaneMask(CubicValue(cubic, piece.end) < CubicValue(cubic, piece.begin));
  const Lanes rises = Select(falls, All(-1.0f), All(1.0f));
  Lanes u = 0.5f * (piece.begin + piece.end);
  for (int i = 0; i < 30 && Any(mask); ++i)
  {
    const Lanes above = rises * (CubicValue(cubic, u) - value);
    const LaneMask isBelow = LaneMask(above < 0.0f);
    piece = { Select(isBelow, u, piece.begin), Select(isBelow, piece.end, u) };
    const Lanes slope = rises * CubicSlope(cubic, u);
    const Lanes newton = u - above / slope;
    const LaneMask isInside =
      LaneMask(slope > 0.0f) & LaneMask(newton > piece.begin) & LaneMask(newton < piece.end);
    const Lanes next = Select(isInside, newton, 0.5f * (piece.begin + piece.end));
    const LaneMask moves = LaneMask(Abs(next - u) > 1e-6f);
    u = Select(mask, next, u); // a ray that has found its place keeps it
    mask &= moves;
  }
  return u;
}

}

}

#endif
