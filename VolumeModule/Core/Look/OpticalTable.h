#ifndef Varimarch_Core_Look_OpticalTable_h
#define Varimarch_Core_Look_OpticalTable_h

#include "Core/Look/TransferFunction.h"
#include "Core/Look/ValueRange.h"

#include <glm/vec4.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace varimarch
{

/// Colour and extinction at equidistant values, for linear interpolation between entries. Entry i
/// holds (r, g, b, extinction [1/mm]) at firstValue + i * (lastValue - firstValue) / (entries - 1);
/// the end entries hold for all values beyond. If firstValue equals lastValue, all entries are
/// equal. An opaque value has OpaqueExtinction, which is finite, so that it can be multiplied by
/// zero and interpolated without a NaN.
struct OpticalTable
{
  double firstValue;
  double lastValue;
  std::vector<glm::vec4> entries; ///< at least two
  /// True if the function has a whole curve between two entries, which are hundreds of times as far
  /// apart: the table then has only its mean.
  bool missesCurve = false;
};

/// Extinction of opaque values [1/mm]. Large enough that the thinnest segment is opaque, and small
/// enough that its product with any length fits a float.
constexpr float OpaqueExtinction = 1e30f;

/// Samples a transfer function over the part of [smallestValue, largestValue] in which it changes,
/// on all cores. The number of entries is a power of two, from 1024 to `mostEntries`, with at least
/// 32 between neighbouring nodes, and from 8192 if a ramp becomes opaque. A step becomes a ramp one
/// entry wide; a function with a step has as many entries as fit if [smallestValue, largestValue]
/// has `mostEntries`. There are two entries if nothing changes. A peak between two entries becomes
/// one entry wide and keeps its integral of extinction over the values, except at the ends: their
/// entries are exact, because whole regions of a volume, such as its background, may have the end's
/// value.
/// @throws std::invalid_argument unless both values are finite and smallestValue <= largestValue
OpticalTable BuildOpticalTable(const TransferFunction& transferFunction, double smallestValue,
  double largestValue, std::size_t mostEntries = 65536);

/// A scalar's index in a table is scalar * scale + bias.
struct IndexInTable
{
  double scale;
  double bias;
};

/// The index of scalars that stand for the values scalar * valueScale + valueOffset; 0 in a table
/// whose first value is its last. Scale and bias are limited, so that the index of no scalar is NaN
/// in floats.
/// @param lastIndex  index of the table's last value
IndexInTable IndexOf(
  const OpticalTable& table, double lastIndex, double valueScale = 1.0, double valueOffset = 0.0);

/// The open range of values in which a table has any extinction. An end is infinite if the end
/// entry has extinction; the range is (infinity, -infinity) if no entry has.
std::array<double, 2> VisibleValues(const OpticalTable& table);

/// The ranges of values at which a function is opaque, ascending; an end is infinite if the
/// function stays opaque. A single opaque value among others that are not, as the tip of a tent, is
/// none: light passes it.
/// @param values  the values that occur: a range of which all or none occur is left out, since
///                opaque matter has no border then
std::vector<ValueRange> OpaqueValues(
  const TransferFunction& transferFunction, const ValueRange& values);

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
