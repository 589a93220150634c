#ifndef Varimarch_Core_Packets_Lanes_h
#define Varimarch_Core_Packets_Lanes_h

// The numbers of a packet, one for each of its rays, in one register: as many as a register of the
// instructions has that this is compiled for. Everything that is made of them has internal linkage,
// because it is compiled once for each set of instructions: a linker that took one copy of a
// function for all would take instructions that a processor may not have.

#ifdef __AVX2__
#include "Core/Packets/LanesAvx2.h"
#else
#include "Core/Packets/LanesPortable.h"
#endif

#include <cstdint>
#include <utility>

// Inlines everything that a function calls, so that lanes stay in registers. With the checks of a
// sanitizer such a function would take a compiler ten minutes.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define FLATTENED
#else
#define FLATTENED [[gnu::flatten]]
#endif

namespace varimarch
{

namespace
{

using LaneMask = IntLanes; ///< all bits or none in each lane

template <class Vector, class Number, int... Lane>
Vector VectorOf(Number number, std::integer_sequence<int, Lane...>)
{
  return Vector{ number(Lane)... };
}

/// The lanes that number(lane), a float, returns.
template <class Number>
Lanes LanesOf(Number number)
{
  return VectorOf<Lanes>(number, std::make_integer_sequence<int, LaneCount>());
}

/// The lanes that number(lane), a std::int32_t, returns.
template <class Number>
IntLanes IntLanesOf(Number number)
{
  return VectorOf<IntLanes>(number, std::make_integer_sequence<int, LaneCount>());
}

inline Lanes All(float number)
{
  return LanesOf([=](int) { return number; });
}

inline IntLanes AllInt(int number)
{
  return IntLanesOf([=](int) { return number; });
}

inline Lanes Min(Lanes a, float b)
{
  return Min(a, All(b));
}

inline Lanes Max(Lanes a, float b)
{
  return Max(a, All(b));
}

inline Lanes Clamp(Lanes number, Lanes least, Lanes most)
{
  return Min(Max(number, least), most);
}

inline Lanes Clamp(Lanes number, float least, float most)
{
  return Clamp(number, All(least), All(most));
}

inline Lanes Clamp(Lanes number, float least, Lanes most)
{
  return Clamp(number, All(least), most);
}

/// Towards zero, for numbers that an int can hold.
inline IntLanes Truncated(Lanes number)
{
  return __builtin_convertvector(number, IntLanes);
}

inline Lanes FloatOf(IntLanes number)
{
  return __builtin_convertvector(number, Lanes);
}

inline Lanes Abs(Lanes number)
{
  return Lanes(IntLanes(number) & 0x7fffffff);
}

inline Lanes Mix(Lanes a, Lanes b, Lanes part)
{
  return a + part * (b - a);
}

inline Lanes LanesAt(const float* numbers)
{
  Lanes lanes;
  __builtin_memcpy(&lanes, numbers, sizeof lanes);
  return lanes;
}

/// Four numbers that lie together in memory.
inline Four FourAt(const float* numbers)
{
  Four four;
  __builtin_memcpy(&four, numbers, sizeof four);
  return four;
}

/// The lanes in memory, for work that each does by itself.
struct IntNumbers
{
  alignas(IntLanes) std::int32_t of[LaneCount];

  IntNumbers() = default;
  explicit IntNumbers(IntLanes lanes) { __builtin_memcpy(this->of, &lanes, sizeof lanes); }
};

/// The same for numbers beyond 32 bits.
struct WideNumbers
{
  std::int64_t of[LaneCount];
};

struct Numbers
{
  alignas(Lanes) float of[LaneCount];

  explicit Numbers(Lanes lanes) { __builtin_memcpy(this->of, &lanes, sizeof lanes); }
};

/// 2^number, for numbers up to 127; below -126 it is 2^-126. Relative error at most 2e-7.
/// Polynomial: minimax on [-1/2, 1/2] of (2^f - 1) / f, as in Cephes' exp2f.
struct PowerOfTwo
{
  Lanes whole;       ///< 2^i
  Lanes partLessOne; ///< 2^f - 1

  explicit PowerOfTwo(Lanes number)
  {
    number = Max(number, All(-126.0f));
    const Lanes rounded = Rounded(number);
    const Lanes f = number - rounded;
    this->whole = Lanes((Truncated(rounded) + 127) << 23);
    Lanes sum = All(1.535336188319500e-4f);
    sum = sum * f + 1.339887440266574e-3f;
    sum = sum * f + 9.618437357674640e-3f;
    sum = sum * f + 5.550332471162809e-2f;
    sum = sum * f + 2.402264791363012e-1f;
    sum = sum * f + 6.931472028550421e-1f;
    this->partLessOne = sum * f;
  }
};

/// 2^number, for numbers from 0 to 2; relative error at most 6e-6, and exactly 1 at 0. Estrin's
/// scheme: its result is waited for.
/// Polynomial: minimax of the relative error on [0, 2].
inline Lanes SmallPowerOfTwo(Lanes number)
{
  const Lanes squared = number * number;
  const Lanes lower = 1.0f + number * 6.93289441e-1f;
  const Lanes middle = 2.39092316e-1f + number * 5.83119361e-2f;
  const Lanes upper = 6.72009978e-3f + number * 2.59419137e-3f;
  return lower + squared * (middle + squared * upper);
}

/// The binary logarithm of numbers above 0; a denormal number counts as the least normal one.
/// ln m = 2 artanh((m - 1) / (m + 1)), with m in [sqrt(1/2), sqrt(2)): five terms of its series
/// have an error of at most 2e-7.
inline Lanes Log2(Lanes number)
{
  number = Max(number, All(1.17549435e-38f));
  const IntLanes bits = IntLanes(number);
  constexpr std::int32_t sqrtHalf = 0x3f3504f3;
  const IntLanes exponent = (bits - sqrtHalf) >> 23;
  const Lanes m = Lanes(bits - (exponent << 23));
  const Lanes s = (m - 1.0f) / (m + 1.0f);
  const Lanes s2 = s * s;
  Lanes series = All(2.0f / 9.0f);
  series = series * s2 + 2.0f / 7.0f;
  series = series * s2 + 2.0f / 5.0f;
  series = series * s2 + 2.0f / 3.0f;
  series = series * s2 + 2.0f;
  return FloatOf(exponent) + 1.442695041f * s * series;
}

/// e^number, for numbers up to 88; below -87 it is e^-87.
inline Lanes Exp(Lanes number)
{
  const PowerOfTwo power(1.442695041f * number);
  return power.whole + power.whole * power.partLessOne;
}

/// The natural logarithm of numbers above 0.
inline Lanes Log(Lanes number)
{
  return 0.693147181f * Log2(number);
}

/// base^exponent, for bases from 0 to 1 and exponents from 0 on; 0 where the base is 0 and the
/// exponent is not.
inline Lanes Power(Lanes base, float exponent)
{
  constexpr float MostSquared = 255.0f;
  if (exponent >= 0.0f && exponent <= MostSquared && exponent == float(int(exponent)))
  {
    Lanes power = All(1.0f);
    for (int bits = int(exponent); bits > 0; bits >>= 1)
    {
      power = (bits & 1) != 0 ? power * base : power;
      base *= base;
    }
    return power;
  }
  const PowerOfTwo power(exponent * Log2(base));
  return Select(LaneMask(base > 0.0f), power.whole + power.whole * power.partLessOne, Lanes{});
}

/// The same for an exponent that all lanes have.
inline Lanes Power(Lanes base, Lanes exponent)
{
  return Power(base, exponent[0]);
}

}

}

#endif
