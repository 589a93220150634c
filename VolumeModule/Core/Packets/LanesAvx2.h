#ifndef Varimarch_Core_Packets_LanesAvx2_h
#define Varimarch_Core_Packets_LanesAvx2_h

// Registers of eight numbers, for processors with AVX2 and FMA: the functions for which a compiler
// finds no single instruction by itself. LanesPortable.h declares the same ones; Lanes.h chooses.

#include <immintrin.h>

#include <cstdint>

namespace varimarch
{

namespace
{

constexpr int LaneCount = 8;

typedef float Lanes __attribute__((vector_size(32)));
typedef std::int32_t IntLanes __attribute__((vector_size(32)));
typedef float Four __attribute__((vector_size(16)));

/// Where one of both is NaN, the second.
inline Lanes Min(Lanes a, Lanes b)
{
  return Lanes(_mm256_min_ps(a, b));
}

/// Where one of both is NaN, the second.
inline Lanes Max(Lanes a, Lanes b)
{
  return Lanes(_mm256_max_ps(a, b));
}

/// @param mask  all bits or none in each lane
inline Lanes Select(IntLanes mask, Lanes yes, Lanes no)
{
  return Lanes(_mm256_blendv_ps(no, yes, __m256(mask)));
}

inline IntLanes Select(IntLanes mask, IntLanes yes, IntLanes no)
{
  return IntLanes(_mm256_blendv_epi8(__m256i(no), __m256i(yes), __m256i(mask)));
}

/// @param mask  all bits or none in each lane
inline bool Any(IntLanes mask)
{
  return _mm256_movemask_ps(__m256(mask)) != 0;
}

inline Lanes Floor(Lanes number)
{
  return Lanes(_mm256_floor_ps(number));
}

/// The nearest whole numbers, for numbers of at most 2^22.
inline Lanes Rounded(Lanes number)
{
  return Lanes(_mm256_round_ps(number, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC));
}

inline Lanes Sqrt(Lanes number)
{
  return Lanes(_mm256_sqrt_ps(number));
}

/// 1 / sqrt(number), by one Newton step from an estimate: relative error at most 3e-7.
inline Lanes InverseSqrt(Lanes number)
{
  const Lanes estimate = Lanes(_mm256_rsqrt_ps(number));
  return estimate * (1.5f - 0.5f * number * estimate * estimate);
}

/// factor * number + sum, rounded once.
inline Four MultiplyAdd(float factor, Four number, Four sum)
{
  return Four(_mm_fmadd_ps(_mm_set1_ps(factor), number, sum));
}

/// The lanes that number(lane), an unsigned 16 bit integer, returns.
template <class Number>
IntLanes WidenedLanes(Number number)
{
  return IntLanes(_mm256_cvtepu16_epi32(_mm_setr_epi16(
    number(0), number(1), number(2), number(3), number(4), number(5), number(6), number(7))));
}

/// The four numbers of a lane, and beside them those of the lane in the same place of the other
/// half: the shuffles below work in both halves alike.
/// @param numbers  (lane), its four numbers
/// @param lane     in the first half
template <class Numbers>
Lanes InBothHalves(Numbers numbers, int lane)
{
  return __builtin_shufflevector(numbers(lane), numbers(lane + 4), 0, 1, 2, 3, 4, 5, 6, 7);
}

/// Two numbers each of two lanes that follow each other, likewise.
/// @param pair  (lane), its two numbers in the bits of a double
template <class Pair>
Lanes PairsInBothHalves(Pair pair, int lane)
{
  typedef double Pairs __attribute__((vector_size(32)));
  return Lanes(Pairs{ pair(lane), pair(lane + 1), pair(lane + 4), pair(lane + 5) });
}

/// The first two numbers of a and b in turn, in each half: a0 b0 a1 b1.
inline Lanes InterleavedLower(Lanes a, Lanes b)
{
  return __builtin_shufflevector(a, b, 0, 8, 1, 9, 4, 12, 5, 13);
}

/// The same of the last two: a2 b2 a3 b3.
inline Lanes InterleavedUpper(Lanes a, Lanes b)
{
  return __builtin_shufflevector(a, b, 2, 10, 3, 11, 6, 14, 7, 15);
}

/// a0 a1 b0 b1 in each half.
inline Lanes JoinedLower(Lanes a, Lanes b)
{
  return __builtin_shufflevector(a, b, 0, 1, 8, 9, 4, 5, 12, 13);
}

/// a2 a3 b2 b3 in each half.
inline Lanes JoinedUpper(Lanes a, Lanes b)
{
  return __builtin_shufflevector(a, b, 2, 3, 10, 11, 6, 7, 14, 15);
}

/// a0 a2 b0 b2 in each half.
inline Lanes EvenNumbers(Lanes a, Lanes b)
{
  return __builtin_shufflevector(a, b, 0, 2, 8, 10, 4, 6, 12, 14);
}

/// a1 a3 b1 b3 in each half.
inline Lanes OddNumbers(Lanes a, Lanes b)
{
  return __builtin_shufflevector(a, b, 1, 3, 9, 11, 5, 7, 13, 15);
}

}

}

#endif
