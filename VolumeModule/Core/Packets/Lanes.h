#ifndef Varimarch_Core_Packets_Lanes_h
#define Varimarch_Core_Packets_Lanes_h

// Eight numbers in a register, one for each ray of a packet. Only for what is compiled for
// processors with AVX2 and FMA: PacketTileAvx2.cxx. The compiler has the operators.

#include <immintrin.h>

#include <cstdint>

namespace varimarch
{

constexpr int LaneCount = 8;

typedef float Lanes __attribute__((vector_size(32)));
typedef std::int32_t IntLanes __attribute__((vector_size(32)));
using LaneMask = IntLanes; ///< of each lane all bits or none

inline Lanes All(float number)
{
  return Lanes(_mm256_set1_ps(number));
}

inline IntLanes AllInt(int number)
{
  return IntLanes(_mm256_set1_epi32(number));
}

/// The second is taken where the first is not a number.
inline Lanes Min(Lanes a, Lanes b)
{
  return Lanes(_mm256_min_ps(a, b));
}

inline Lanes Max(Lanes a, Lanes b)
{
  return Lanes(_mm256_max_ps(a, b));
}

inline Lanes Clamp(Lanes number, Lanes least, Lanes most)
{
  return Min(Max(number, least), most);
}

inline Lanes Floor(Lanes number)
{
  return Lanes(_mm256_floor_ps(number));
}

inline IntLanes Truncated(Lanes number)
{
  return IntLanes(_mm256_cvttps_epi32(number));
}

inline Lanes FloatOf(IntLanes number)
{
  return Lanes(_mm256_cvtepi32_ps(__m256i(number)));
}

inline Lanes Sqrt(Lanes number)
{
  return Lanes(_mm256_sqrt_ps(number));
}

/// 1 / sqrt(number), by one of Newton's steps from an estimate: within 3e-7, relative.
inline Lanes InverseSqrt(Lanes number)
{
  const Lanes estimate = Lanes(_mm256_rsqrt_ps(number));
  return estimate * (1.5f - 0.5f * number * estimate * estimate);
}

inline Lanes Abs(Lanes number)
{
  return Lanes(_mm256_andnot_ps(_mm256_set1_ps(-0.0f), number));
}

inline Lanes WithSignOf(Lanes size, Lanes sign)
{
  return Lanes(_mm256_or_ps(size, _mm256_and_ps(_mm256_set1_ps(-0.0f), sign)));
}

inline Lanes Select(LaneMask mask, Lanes yes, Lanes no)
{
  return Lanes(_mm256_blendv_ps(no, yes, __m256(mask)));
}

inline IntLanes Select(LaneMask mask, IntLanes yes, IntLanes no)
{
  return IntLanes(_mm256_blendv_epi8(__m256i(no), __m256i(yes), __m256i(mask)));
}

inline bool Any(LaneMask mask)
{
  return _mm256_movemask_ps(__m256(mask)) != 0;
}

inline Lanes Mix(Lanes a, Lanes b, Lanes part)
{
  return a + part * (b - a);
}

/// The lanes in memory, for what each does by itself.
struct IntNumbers
{
  alignas(32) std::int32_t of[LaneCount];

  IntNumbers() = default;
  explicit IntNumbers(IntLanes lanes)
  {
    _mm256_store_si256(reinterpret_cast<__m256i*>(this->of), __m256i(lanes));
  }
};

struct Numbers
{
  alignas(32) float of[LaneCount];

  explicit Numbers(Lanes lanes) { _mm256_store_ps(this->of, lanes); }
};

struct Lanes3
{
  Lanes x;
  Lanes y;
  Lanes z;
};

struct Lanes4
{
  Lanes x;
  Lanes y;
  Lanes z;
  Lanes w;
};

/// Four numbers of each lane, which are together in memory.
inline Lanes4 Transposed(const __m128 (&numbers)[LaneCount])
{
  const auto pair = [&](int lane)
  { return _mm256_insertf128_ps(_mm256_castps128_ps256(numbers[lane]), numbers[lane + 4], 1); };
  const __m256 lower = _mm256_unpacklo_ps(pair(0), pair(1));
  const __m256 upper = _mm256_unpackhi_ps(pair(0), pair(1));
  const __m256 lowerNext = _mm256_unpacklo_ps(pair(2), pair(3));
  const __m256 upperNext = _mm256_unpackhi_ps(pair(2), pair(3));
  return { Lanes(_mm256_shuffle_ps(lower, lowerNext, 0x44)),
    Lanes(_mm256_shuffle_ps(lower, lowerNext, 0xee)),
    Lanes(_mm256_shuffle_ps(upper, upperNext, 0x44)),
    Lanes(_mm256_shuffle_ps(upper, upperNext, 0xee)) };
}

inline Lanes3 operator+(const Lanes3& a, const Lanes3& b)
{
  return { a.x + b.x, a.y + b.y, a.z + b.z };
}

inline Lanes3 operator-(const Lanes3& a, const Lanes3& b)
{
  return { a.x - b.x, a.y - b.y, a.z - b.z };
}

inline Lanes3 operator*(Lanes factor, const Lanes3& a)
{
  return { factor * a.x, factor * a.y, factor * a.z };
}

inline Lanes Dot(const Lanes3& a, const Lanes3& b)
{
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

inline Lanes Length(const Lanes3& a)
{
  return Sqrt(Dot(a, a));
}

/// 2^number, for numbers from -126 to 127; below, 2^-126. Within 2e-7, relative.
/// Polynomial: minimax on [-1/2, 1/2] of (2^f - 1) / f, as in Cephes' exp2f.
struct PowerOfTwo
{
  Lanes whole;       ///< 2^i
  Lanes partLessOne; ///< 2^f - 1

  explicit PowerOfTwo(Lanes number)
  {
    number = Max(number, All(-126.0f));
    const Lanes rounded =
      Lanes(_mm256_round_ps(number, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC));
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

/// 2^number, for numbers from 0 to 2; within 6e-6, relative, and 1 of 0. By Estrin's scheme: for
/// what waits for it.
/// Polynomial: minimax of the relative error on [0, 2].
inline Lanes SmallPowerOfTwo(Lanes number)
{
  const Lanes squared = number * number;
  const Lanes lower = 1.0f + number * 6.93289441e-1f;
  const Lanes middle = 2.39092316e-1f + number * 5.83119361e-2f;
  const Lanes upper = 6.72009978e-3f + number * 2.59419137e-3f;
  return lower + squared * (middle + squared * upper);
}

/// The binary logarithm of numbers above 0, of which denormalised ones count as the least other.
/// ln m = 2 artanh((m - 1) / (m + 1)), with m in [sqrt(1/2), sqrt(2)): five terms of its series are
/// within 2e-7 of the logarithm.
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

/// base^exponent, for bases from 0 to 1; 0 of 0.
inline Lanes Power(Lanes base, float exponent)
{
  constexpr float MostSquared = 255.0f;
  if (exponent >= 1.0f && exponent <= MostSquared && exponent == float(int(exponent)))
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

}

#endif
