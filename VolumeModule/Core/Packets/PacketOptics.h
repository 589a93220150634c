#ifndef Varimarch_Core_Packets_PacketOptics_h
#define Varimarch_Core_Packets_PacketOptics_h

// The optical properties of values, and the sum of the parts of a ray.

#include "Core/Packets/PacketScene.h"
#include "Core/Packets/ShaderMath.h"

namespace varimarch
{

namespace
{

/// Colour and extinction [1/mm], or emission and extinction.
struct Optical
{
  Lanes3 color;
  Lanes extinction;
};

inline Optical OpticalOf(const Four (&entries)[LaneCount])
{
  const Lanes4 numbers = Transposed(entries);
  return { { numbers.x, numbers.y, numbers.z }, numbers.w };
}

/// The lanes in which any value from one to another, both included, may absorb.
inline LaneMask MayAbsorb(const PacketLook& look, Lanes start, Lanes end)
{
  return LaneMask(Max(start, end) > look.visibleValues.x) &
    LaneMask(Min(start, end) < look.visibleValues.y);
}

/// Interpolates between an entry and the next.
inline Four MixedEntries(const glm::vec4* entry, float part)
{
  const Four first = FourAt(&entry->x);
  return first + part * (FourAt(&entry[1].x) - first);
}

/// Shaders/Classify/OpticalTable.glsl.
inline Optical Classify(const PacketLook& look, Lanes value)
{
  const Lanes last = All(float(look.lastIndex));
  const Lanes place = TableIndex(value, All(look.indexScale), All(look.indexOffset), last);
  const Lanes below = EntryBelow(place, last);
  const IntNumbers index(Truncated(below));
  const Numbers part(place - below);
  Four entries[LaneCount];
  for (int lane = 0; lane < LaneCount; ++lane)
  {
    entries[lane] = MixedEntries(look.table + index.of[lane], part.of[lane]);
  }
  return OpticalOf(entries);
}

/// Interpolates between four entries of a table of rows.
/// @param size  of the table, at least two along each axis
/// @param x, y  indices within the table, which need not be whole
inline Optical Interpolated(const glm::vec4* table, glm::ivec2 size, Lanes x, Lanes y)
{
  const Lanes column = EntryBelow(x, All(float(size.x - 1)));
  const Lanes row = EntryBelow(y, All(float(size.y - 1)));
  const IntNumbers index(Truncated(column) + size.x * Truncated(row));
  const Numbers along(x - column);
  const Numbers across(y - row);
  Four entries[LaneCount];
  for (int lane = 0; lane < LaneCount; ++lane)
  {
    const glm::vec4* const entry = table + index.of[lane];
    const Four lower = MixedEntries(entry, along.of[lane]);
    const Four upper = MixedEntries(entry + size.x, along.of[lane]);
    entries[lane] = lower + across.of[lane] * (upper - lower);
  }
  return OpticalOf(entries);
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
    const Lanes4 mean =
      WithEnds({ emission.color.x, emission.color.y, emission.color.z, emission.extinction }, start,
        end, last, AllOf4(look.emissionBelow), AllOf4(look.emissionAbove));
    emission = { { mean.x, mean.y, mean.z }, mean.w };
  }
  return { (1.0f / Max(emission.extinction, All(1e-30f))) * emission.color, emission.extinction };
}

/// Emission and absorption, front to back; see Shaders/Blend/Composite.glsl.
struct PacketSum
{
  Lanes3 color = { Lanes{}, Lanes{}, Lanes{} }; ///< premultiplied
  Lanes transmittance = All(1.0f);
  Lanes opticalDepth = {}; ///< of all parts; it is known before the transmittance

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

}

#endif
