#ifndef Varimarch_Core_Packets_PacketCellCubic_h
#define Varimarch_Core_Packets_PacketCellCubic_h

// The interpolated values along a line through a cell, which are exactly a cubic: see
// Core/Geometry/CellCubic.h and Shaders/Math/CellCubic.glsl.

#include "Core/Packets/Lanes.h"
#include "Core/Packets/PacketVoxels.h"

namespace varimarch
{

namespace
{

/// A cubic by its Bernstein coefficients, whose range it never leaves.
struct CellCubicLanes
{
  Lanes b0;
  Lanes b1;
  Lanes b2;
  Lanes b3;

  /// De Casteljau's algorithm.
  /// @param u  [0, 1]
  Lanes ValueAt(Lanes u) const
  {
    const Lanes middle = Mix(this->b1, this->b2, u);
    const Lanes left = Mix(Mix(this->b0, this->b1, u), middle, u);
    const Lanes right = Mix(middle, Mix(this->b2, this->b3, u), u);
    return Mix(left, right, u);
  }

  Lanes SlopeAt(Lanes u) const
  {
    const Lanes middle = this->b2 - this->b1;
    return 3.0f * Mix(Mix(this->b1 - this->b0, middle, u), Mix(middle, this->b3 - this->b2, u), u);
  }
};

inline CellCubicLanes operator*(float factor, const CellCubicLanes& a)
{
  return { factor * a.b0, factor * a.b1, factor * a.b2, factor * a.b3 };
}

/// The cubics along lines, each of which lies in one cell. The coefficients follow from the values
/// at the corners of the box between the ends of a line.
/// @param enterGrid, leaveGrid  the ends
inline CellCubicLanes CubicBetween(
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

/// The places in [0, 1] where a cubic has extremes; 0 or 1 instead of one outside.
struct ExtremePlaces
{
  Lanes first;
  Lanes second;
};

inline ExtremePlaces ExtremesOf(const CellCubicLanes& cubic)
{
  const Lanes3 slopes{ cubic.b1 - cubic.b0, cubic.b2 - cubic.b1, cubic.b3 - cubic.b2 };
  const Lanes a = slopes.x - 2.0f * slopes.y + slopes.z;
  const Lanes halfB = slopes.y - slopes.x;
  const Lanes discriminant = halfB * halfB - a * slopes.x;
  const Lanes q = -(halfB + WithSignOf(Sqrt(Max(discriminant, Lanes{})), halfB));
  const auto within = [&](Lanes dividend, Lanes divisor)
  {
    const Lanes place = Clamp(dividend / divisor, Lanes{}, All(1.0f));
    const LaneMask has = LaneMask(discriminant > 0.0f) & LaneMask(divisor != 0.0f);
    return Select(has, place, Lanes{});
  };
  return { within(q, a), within(slopes.x, q) };
}

}

}

#endif
