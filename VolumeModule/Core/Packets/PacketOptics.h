#ifndef Varimarch_Core_Packets_PacketOptics_h
#define Varimarch_Core_Packets_PacketOptics_h

// What values look like, and how the parts of a ray become its pixel.

#include "Core/Packets/Lanes.h"
#include "Core/Packets/PacketScene.h"

namespace varimarch
{

/// Colour and extinction [1/mm], or emission and extinction.
struct Optical
{
  Lanes3 color;
  Lanes extinction;
};

inline Optical OpticalOf(const __m128 (&entries)[LaneCount])
{
  const Lanes4 numbers = Transposed(entries);
  return { { numbers.x, numbers.y, numbers.z }, numbers.w };
}

/// Whether anything does between two values, both included.
inline LaneMask MayAbsorb(const PacketLook& look, Lanes start, Lanes end)
{
  return LaneMask(Max(start, end) > look.visibleValues.x) &
    LaneMask(Min(start, end) < look.visibleValues.y);
}

/// Between an entry and the next.
inline __m128 MixedEntries(const glm::vec4* entry, float part)
{
  const __m128 a = _mm_loadu_ps(&entry->x);
  const __m128 b = _mm_loadu_ps(&entry[1].x);
  return _mm_fmadd_ps(_mm_set1_ps(part), _mm_sub_ps(b, a), a);
}

/// Shaders/Classify/OpticalTable.glsl.
inline Optical Classify(const PacketLook& look, Lanes value)
{
  const Lanes last = All(float(look.lastIndex));
  const Lanes place = Clamp(value * look.indexScale + look.indexOffset, Lanes{}, last);
  const IntLanes below = Truncated(Min(place, last - 1.0f));
  const IntNumbers index(below);
  const Numbers part(place - FloatOf(below));
  __m128 entries[LaneCount];
  for (int lane = 0; lane < LaneCount; ++lane)
  {
    entries[lane] = MixedEntries(look.table + index.of[lane], part.of[lane]);
  }
  return OpticalOf(entries);
}

/// Between four entries of a table of rows.
/// @param size  of the table, at least two along each axis
/// @param x  and y: indices inside, which need not be whole
inline Optical Interpolated(const glm::vec4* table, glm::ivec2 size, Lanes x, Lanes y)
{
  const IntLanes column = Truncated(Min(x, All(float(size.x - 2))));
  const IntLanes row = Truncated(Min(y, All(float(size.y - 2))));
  const IntNumbers index(column + size.x * row);
  const Numbers along(x - FloatOf(column));
  const Numbers across(y - FloatOf(row));
  __m128 entries[LaneCount];
  for (int lane = 0; lane < LaneCount; ++lane)
  {
    const glm::vec4* const entry = table + index.of[lane];
    const __m128 lower = MixedEntries(entry, along.of[lane]);
    const __m128 upper = MixedEntries(entry + size.x, along.of[lane]);
    entries[lane] = _mm_fmadd_ps(_mm_set1_ps(across.of[lane]), _mm_sub_ps(upper, lower), lower);
  }
  return OpticalOf(entries);
}

/// Of pieces of which some are beyond the table's ends: what is there has the properties of its
/// first or last entry.
inline Optical WithEnds(const PacketLook& look, const Optical& inside, Lanes start, Lanes end)
{
  const Lanes one = All(1.0f);
  const Lanes last = All(float(look.lastIndex));
  const Lanes lower = Min(start, end);
  const Lanes upper = Max(start, end);
  const Lanes extent = Max(upper - lower, All(1e-12f));
  const Lanes below = Select(LaneMask(upper <= 0.0f), one, Clamp(-lower / extent, Lanes{}, one));
  const Lanes above =
    Select(LaneMask(lower >= last), one, Clamp((upper - last) / extent, Lanes{}, one));
  const Lanes within = Max(one - below - above, Lanes{});
  const Lanes ofBelow = below * look.below.w;
  const Lanes ofAbove = above * look.above.w;
  return { { within * inside.color.x + ofBelow * look.below.x + ofAbove * look.above.x,
             within * inside.color.y + ofBelow * look.below.y + ofAbove * look.above.y,
             within * inside.color.z + ofBelow * look.below.z + ofAbove * look.above.z },
    within * inside.extinction + ofBelow + ofAbove };
}

/// Shaders/Classify/PreIntegrated.glsl.
inline Optical ClassifyBetween(const PacketLook& look, Lanes startValue, Lanes endValue)
{
  const Lanes last = All(float(look.lastIndex));
  const Lanes start = startValue * look.indexScale + look.indexOffset;
  const Lanes end = endValue * look.indexScale + look.indexOffset;
  Optical emission = Interpolated(look.table, glm::ivec2(look.lastIndex + 1),
    Clamp(start, Lanes{}, last), Clamp(end, Lanes{}, last));
  if (Any(LaneMask(Min(start, end) < 0.0f) | LaneMask(Max(start, end) > last)))
  {
    emission = WithEnds(look, emission, start, end);
  }
  return { (1.0f / Max(emission.extinction, All(1e-30f))) * emission.color, emission.extinction };
}

/// Shaders/Math/Absorption.glsl: 1 - exp(-depth), without cancellation. Beyond a depth of 100
/// nothing of a float is left.
inline Lanes Absorption(Lanes depth)
{
  const PowerOfTwo power(-1.442695041f * Min(depth, All(100.0f))); // 1 - 2^i - 2^i (2^f - 1)
  return (1.0f - power.whole) - power.whole * power.partLessOne;
}

/// Emission and absorption, front to back; see Shaders/Blend/Composite.glsl.
struct PacketSum
{
  Lanes3 color = { Lanes{}, Lanes{}, Lanes{} }; ///< premultiplied
  Lanes transmittance = All(1.0f);
  Lanes opticalDepth = {}; ///< of all parts: known before the transmittance is

  void Add(const Optical& optical, Lanes lengthMm)
  {
    const Lanes depth = Min(optical.extinction * lengthMm, All(100.0f));
    this->opticalDepth += depth;
    const Lanes seen = this->transmittance * Absorption(depth);
    this->color = this->color + seen * optical.color;
    this->transmittance -= seen;
  }
};

inline PacketSum Select(LaneMask mask, const PacketSum& yes, const PacketSum& no)
{
  return { { Select(mask, yes.color.x, no.color.x), Select(mask, yes.color.y, no.color.y),
             Select(mask, yes.color.z, no.color.z) },
    Select(mask, yes.transmittance, no.transmittance),
    Select(mask, yes.opticalDepth, no.opticalDepth) };
}

}

#endif
