#ifndef Varimarch_Core_Look_ExtinctionSums_h
#define Varimarch_Core_Look_ExtinctionSums_h

#include "Core/Look/OpticalTable.h"

#include <vector>

namespace varimarch
{

/// The integral of a table's extinction over its values, from its first entry to each of the others
/// [entries / mm]. Where values change linearly along a ray, their mean extinction is a difference
/// quotient of it, so that no peak of the transfer function is missed (Max, Hanrahan, Crawfis
/// 1990).
/// @param mostExtinction  larger extinctions count as this one [1/mm]
inline std::vector<double> ExtinctionSums(const OpticalTable& table, double mostExtinction)
{
  const auto extinctionOf = [&](const glm::vec4& entry)
  { return double(entry.w) < mostExtinction ? double(entry.w) : mostExtinction; };
  std::vector<double> sums = { 0.0 };
  for (std::size_t i = 1; i < table.entries.size(); ++i)
  {
    sums.push_back(
      sums.back() + 0.5 * (extinctionOf(table.entries[i - 1]) + extinctionOf(table.entries[i])));
  }
  return sums;
}

}

#endif
