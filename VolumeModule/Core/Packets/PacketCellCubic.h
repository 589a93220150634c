#ifndef Varimarch_Core_Packets_PacketCellCubic_h
#define Varimarch_Core_Packets_PacketCellCubic_h

// The interpolated values along a line through a cell, which are exactly a cubic: see
// Core/Geometry/CellCubic.h and Shaders/Math/CellCubic.glsl.

#include "Core/Packets/Interpolation/Linear.h"
#include "Core/Packets/ShaderMath.h"

namespace varimarch
{

namespace
{

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
