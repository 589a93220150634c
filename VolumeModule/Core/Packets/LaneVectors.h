#ifndef Varimarch_Core_Packets_LaneVectors_h
#define Varimarch_Core_Packets_LaneVectors_h

// Vectors of lanes, with the members and the arithmetic of GLSL's vectors.

#include "Core/Packets/Lanes.h"

#include <type_traits>

namespace varimarch
{

namespace
{

struct Lanes2
{
  Lanes x;
  Lanes y;

  Lanes2() = default;
  Lanes2(Lanes newX, Lanes newY)
    : x(newX)
    , y(newY)
  {
  }
};

struct Lanes3
{
  Lanes x;
  Lanes y;
  Lanes z;

  Lanes3() = default;
  Lanes3(Lanes newX, Lanes newY, Lanes newZ)
    : x(newX)
    , y(newY)
    , z(newZ)
  {
  }
  explicit Lanes3(float all)
    : Lanes3(All(all), All(all), All(all))
  {
  }
  explicit Lanes3(Lanes all)
    : Lanes3(all, all, all)
  {
  }
};

struct Lanes4
{
  Lanes x;
  Lanes y;
  Lanes z;
  Lanes w;

  Lanes4() = default;
  Lanes4(Lanes newX, Lanes newY, Lanes newZ, Lanes newW)
    : x(newX)
    , y(newY)
    , z(newZ)
    , w(newW)
  {
  }
};

struct LaneMask3
{
  LaneMask x;
  LaneMask y;
  LaneMask z;
};

/// A vector that all lanes have.
/// @tparam Vector  with members x, y and z
template <class Vector>
Lanes3 AllOf3(const Vector& vector)
{
  return { All(vector.x), All(vector.y), All(vector.z) };
}

template <class Vector>
Lanes4 AllOf4(const Vector& vector)
{
  return { All(vector.x), All(vector.y), All(vector.z), All(vector.w) };
}

/// The four numbers that each lane has together in memory.
inline Lanes4 Transposed(const Four (&numbers)[LaneCount])
{
  const auto numbersOf = [&](int lane)
  { return InBothHalves([&](int index) { return numbers[index]; }, lane); };
  const Lanes lower = InterleavedLower(numbersOf(0), numbersOf(1));
  const Lanes upper = InterleavedUpper(numbersOf(0), numbersOf(1));
  const Lanes lowerNext = InterleavedLower(numbersOf(2), numbersOf(3));
  const Lanes upperNext = InterleavedUpper(numbersOf(2), numbersOf(3));
  return { JoinedLower(lower, lowerNext), JoinedUpper(lower, lowerNext),
    JoinedLower(upper, upperNext), JoinedUpper(upper, upperNext) };
}

inline Lanes3 operator+(const Lanes3& a, const Lanes3& b)
{
  return { a.x + b.x, a.y + b.y, a.z + b.z };
}

inline Lanes3 operator-(const Lanes3& a, const Lanes3& b)
{
  return { a.x - b.x, a.y - b.y, a.z - b.z };
}

inline Lanes3 operator-(const Lanes3& a)
{
  return { -a.x, -a.y, -a.z };
}

inline Lanes3 operator*(const Lanes3& a, const Lanes3& b)
{
  return { a.x * b.x, a.y * b.y, a.z * b.z };
}

inline Lanes3 operator/(const Lanes3& a, const Lanes3& b)
{
  return { a.x / b.x, a.y / b.y, a.z / b.z };
}

/// A number for each lane, or one that all lanes have.
template <class Number>
using RequireNumber =
  std::enable_if_t<std::is_same_v<Number, Lanes> || std::is_same_v<Number, float>>;

template <class Number, class = RequireNumber<Number>>
Lanes3 operator+(const Lanes3& a, Number b)
{
  return { a.x + b, a.y + b, a.z + b };
}

template <class Number, class = RequireNumber<Number>>
Lanes3 operator-(const Lanes3& a, Number b)
{
  return { a.x - b, a.y - b, a.z - b };
}

template <class Number, class = RequireNumber<Number>>
Lanes3 operator-(Number a, const Lanes3& b)
{
  return { a - b.x, a - b.y, a - b.z };
}

template <class Number, class = RequireNumber<Number>>
Lanes3 operator+(Number a, const Lanes3& b)
{
  return { a + b.x, a + b.y, a + b.z };
}

template <class Number, class = RequireNumber<Number>>
Lanes3 operator*(Number factor, const Lanes3& a)
{
  return { factor * a.x, factor * a.y, factor * a.z };
}

template <class Number, class = RequireNumber<Number>>
Lanes3 operator*(const Lanes3& a, Number factor)
{
  return { a.x * factor, a.y * factor, a.z * factor };
}

inline Lanes4 operator+(const Lanes4& a, const Lanes4& b)
{
  return { a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w };
}

inline Lanes4 operator*(Lanes factor, const Lanes4& a)
{
  return { factor * a.x, factor * a.y, factor * a.z, factor * a.w };
}

inline Lanes Dot(const Lanes3& a, const Lanes3& b)
{
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

inline Lanes3 Cross(const Lanes3& a, const Lanes3& b)
{
  return { a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x };
}

inline Lanes Length(const Lanes3& a)
{
  return Sqrt(Dot(a, a));
}

inline Lanes3 Floor(const Lanes3& a)
{
  return { Floor(a.x), Floor(a.y), Floor(a.z) };
}

inline Lanes3 Abs(const Lanes3& a)
{
  return { Abs(a.x), Abs(a.y), Abs(a.z) };
}

inline Lanes3 Max(const Lanes3& a, const Lanes3& b)
{
  return { Max(a.x, b.x), Max(a.y, b.y), Max(a.z, b.z) };
}

inline Lanes3 Clamp(const Lanes3& a, const Lanes3& least, const Lanes3& most)
{
  return { Clamp(a.x, least.x, most.x), Clamp(a.y, least.y, most.y), Clamp(a.z, least.z, most.z) };
}

inline Lanes3 Mix(const Lanes3& a, const Lanes3& b, Lanes part)
{
  return { Mix(a.x, b.x, part), Mix(a.y, b.y, part), Mix(a.z, b.z, part) };
}

inline Lanes3 Select(LaneMask mask, const Lanes3& yes, const Lanes3& no)
{
  return { Select(mask, yes.x, no.x), Select(mask, yes.y, no.y), Select(mask, yes.z, no.z) };
}

/// b where the mask is set, else a.
inline Lanes3 Mix(const Lanes3& a, const Lanes3& b, const LaneMask3& isSecond)
{
  return { Select(isSecond.x, b.x, a.x), Select(isSecond.y, b.y, a.y),
    Select(isSecond.z, b.z, a.z) };
}

/// 0 where a number is below the edge, else 1.
inline Lanes3 Step(const Lanes3& edge, const Lanes3& a)
{
  const auto step = [](Lanes from, Lanes number)
  { return Select(LaneMask(number < from), Lanes{}, All(1.0f)); };
  return { step(edge.x, a.x), step(edge.y, a.y), step(edge.z, a.z) };
}

inline LaneMask3 LessThanEqual(const Lanes3& a, const Lanes3& b)
{
  return { LaneMask(a.x <= b.x), LaneMask(a.y <= b.y), LaneMask(a.z <= b.z) };
}

}

}

#endif
