#ifndef Varimarch_Core_Packets_LanesPortable_h
#define Varimarch_Core_Packets_LanesPortable_h

// Registers of four numbers, as SSE2 and NEON have them, in the vector types of GCC and Clang and
// without any intrinsic. LanesAvx2.h declares the same functions; Lanes.h chooses.

#include <cstdint>

namespace varimarch
{

namespace
{

constexpr int LaneCount = 4;

typedef float Lanes __attribute__((vector_size(16)));
typedef std::int32_t IntLanes __attribute__((vector_size(16)));
typedef float Four __attribute__((vector_size(16)));

/// Where one of both is NaN, the second.
inline Lanes Min(Lanes a, Lanes b)
{
  return a < b ? a : b;
}

/// Where one of both is NaN, the second.
inline Lanes Max(Lanes a, Lanes b)
{
  return a > b ? a : b;
}

/// @param mask  all bits or none in each lane
inline IntLanes Select(IntLanes mask, IntLanes yes, IntLanes no)
{
  return (mask & yes) | (~mask & no);
}

inline Lanes Select(IntLanes mask, Lanes yes, Lanes no)
{
  return Lanes(Select(mask, IntLanes(yes), IntLanes(no)));
}

/// @param mask  all bits or none in each lane
inline bool Any(IntLanes mask)
{
  typedef std::int64_t Halves __attribute__((vector_size(16)));
  const Halves halves = Halves(mask);
  return (halves[0] | halves[1]) != 0;
}

inline Lanes Floor(Lanes number)
{
  constexpr float FromHereOnWhole = 8388608.0f; // 2^23
  const Lanes size = Lanes(IntLanes(number) & 0x7fffffff);
  const Lanes towardsZero =
    __builtin_convertvector(__builtin_convertvector(number, IntLanes), Lanes);
  const IntLanes isAbove = IntLanes(towardsZero > number);
  const Lanes floor = towardsZero + __builtin_convertvector(isAbove, Lanes); // a mask is -1
  return Select(IntLanes(size < FromHereOnWhole), floor, number);
}

/// The nearest whole numbers, for numbers of at most 2^22: in the sum no bit is left for a
/// fraction.
inline Lanes Rounded(Lanes number)
{
  constexpr float Shift = 12582912.0f; // 1.5 * 2^23
  return (number + Shift) - Shift;
}

/// One instruction, when compiled with -fno-math-errno.
inline Lanes Sqrt(Lanes number)
{
  return Lanes{ __builtin_sqrtf(number[0]), __builtin_sqrtf(number[1]), __builtin_sqrtf(number[2]),
    __builtin_sqrtf(number[3]) };
}

inline Lanes InverseSqrt(Lanes number)
{
  return 1.0f / Sqrt(number);
}

/// factor * number + sum.
inline Four MultiplyAdd(float factor, Four number, Four sum)
{
  return sum + factor * number;
}

/// The lanes that number(lane), an unsigned 16 bit integer, returns.
template <class Number>
IntLanes WidenedLanes(Number number)
{
  return IntLanes{ number(0), number(1), number(2), number(3) };
}

/// The four numbers of a lane: here a register has no second half.
/// @param numbers  (lane), its four numbers
template <class Numbers>
Lanes InBothHalves(Numbers numbers, int lane)
{
  return numbers(lane);
}

/// Two numbers each of two lanes that follow each other.
/// @param pair  (lane), its two numbers in the bits of a double
template <class Pair>
Lanes PairsInBothHalves(Pair pair, int lane)
{
  typedef double Pairs __attribute__((vector_size(16)));
  return Lanes(Pairs{ pair(lane), pair(lane + 1) });
}

/// The first two numbers of a and b in turn: a0 b0 a1 b1.
inline Lanes InterleavedLower(Lanes a, Lanes b)
{
  return __builtin_shufflevector(a, b, 0, 4, 1, 5);
}

/// The same of the last two: a2 b2 a3 b3.
inline Lanes InterleavedUpper(Lanes a, Lanes b)
{
  return __builtin_shufflevector(a, b, 2, 6, 3, 7);
}

/// a0 a1 b0 b1.
inline Lanes JoinedLower(Lanes a, Lanes b)
{
  return __builtin_shufflevector(a, b, 0, 1, 4, 5);
}

/// a2 a3 b2 b3.
inline Lanes JoinedUpper(Lanes a, Lanes b)
{
  return __builtin_shufflevector(a, b, 2, 3, 6, 7);
}

/// a0 a2 b0 b2.
inline Lanes EvenNumbers(Lanes a, Lanes b)
{
  return __builtin_shufflevector(a, b, 0, 2, 4, 6);
}

/// a1 a3 b1 b3.
inline Lanes OddNumbers(Lanes a, Lanes b)
{
  return __builtin_shufflevector(a, b, 1, 3, 5, 7);
}

}

}

#endif
