#ifndef Varimarch_Core_Packets_Classify_OpticalTable_h
#define Varimarch_Core_Packets_Classify_OpticalTable_h

// Twin of Classify/OpticalTable.glsl.

#include "Core/Packets/PacketTables.h"

namespace varimarch
{

namespace
{

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

/// The extinction alone [1/mm].
inline Lanes ExtinctionOf(const PacketLook& look, Lanes value)
{
  const Lanes last = All(float(look.lastIndex));
  const Lanes place = TableIndex(value, All(look.indexScale), All(look.indexOffset), last);
  const Lanes below = EntryBelow(place, last);
  const IntNumbers index(Truncated(below));
  const Lanes first = LanesOf([&](int lane) { return look.table[index.of[lane]].w; });
  const Lanes next = LanesOf([&](int lane) { return look.table[index.of[lane] + 1].w; });
  return Mix(first, next, place - below);
}

}

}

#endif
