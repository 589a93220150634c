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

/// The part of ExtinctionSums between places in the table.
inline Lanes SumBetween(const PacketLook& look, Lanes first, Lanes second)
{
  const Lanes last = All(float(look.lastIndex));
  const Lanes below[2] = { EntryBelow(first, last), EntryBelow(second, last) };
  const IntNumbers index[2] = { IntNumbers(Truncated(below[0])), IntNumbers(Truncated(below[1])) };
  const Numbers part[2] = { Numbers(first - below[0]), Numbers(second - below[1]) };
  const auto sumAt = [&](int end, int lane)
  {
    const double* const sums = look.sums + index[end].of[lane];
    return sums[0] + double(part[end].of[lane]) * (sums[1] - sums[0]);
  };
  return LanesOf([&](int lane) { return float(sumAt(1, lane) - sumAt(0, lane)); });
}

/// The mean extinction of values that change linearly from one to another [1/mm].
/// @param most  larger extinctions count as this one
inline Lanes MeanExtinctionOf(const PacketLook& look, Lanes start, Lanes end, Lanes most)
{
  constexpr float FarOutside = 1e9f; // entries
  const Lanes last = All(float(look.lastIndex));
  const auto placeOf = [&](Lanes value)
  {
    return Clamp(
      value * look.indexScale + look.indexOffset, All(-FarOutside), last + All(FarOutside));
  };
  const Lanes from = placeOf(start);
  const Lanes to = placeOf(end);
  const LaneMask isOneEntry = LaneMask(Abs(to - from) < 1.0f);
  const Lanes ofMiddle = Min(ExtinctionOf(look, 0.5f * (start + end)), most);
  if (!Any(~isOneEntry))
  {
    return ofMiddle;
  }
  const Lanes inside = SumBetween(look, Clamp(from, Lanes{}, last), Clamp(to, Lanes{}, last));
  const Lanes below = Min(to, Lanes{}) - Min(from, Lanes{});
  const Lanes above = Max(to, last) - Max(from, last);
  const Lanes sum = inside + below * Min(All(look.table[0].w), most) +
    above * Min(All(look.table[look.lastIndex].w), most);
  return Select(isOneEntry, ofMiddle, sum / Select(isOneEntry, All(1.0f), to - from));
}

}

}

#endif
