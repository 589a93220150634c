#ifndef Varimarch_Core_Packets_PacketTables_h
#define Varimarch_Core_Packets_PacketTables_h

// Tables of optical properties, and how lanes read them.

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

/// Interpolates between four entries of a table of rows.
/// @param size  number of entries along each axis, at least two
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

}

}

#endif
