#ifndef Varimarch_Core_Look_PreIntegratedTable_h
#define Varimarch_Core_Look_PreIntegratedTable_h

#include "Core/Look/OpticalTable.h"

#include <vector>

namespace varimarch
{

/// The most values on a side of a table that is built.
inline constexpr std::size_t MostPreIntegratedValues = 1024;

/// A transfer function integrated over pieces of a ray along which the scalar changes linearly from
/// one value to another. Entry (i, j) holds the mean extinction and the mean emission (extinction
/// times colour) over the values from i to j, which are equidistant in [firstValue, lastValue]. It
/// holds emission, because interpolation between entries would mix a colour with that of invisible
/// values.
///
/// Mean extinction times length is the exact optical depth, so no peak of the transfer function
/// falls between two samples. Source: Engel, Kraus, Ertl, "High-quality pre-integrated volume
/// rendering using hardware-accelerated pixel shading" (Graphics Hardware 2001). This table ignores
/// the order of colours within a piece; it therefore does not depend on the length and is
/// symmetric.
struct PreIntegratedTable
{
  double firstValue;
  double lastValue;
  int size;                       ///< entries along each side, >= 2
  std::vector<glm::vec4> entries; ///< (emission, extinction) [1/mm], size * size of them
};

/// @param mostEntries  upper bound of size * size, >= 4
PreIntegratedTable BuildPreIntegratedTable(const OpticalTable& table,
  std::size_t mostEntries = MostPreIntegratedValues * MostPreIntegratedValues);

/// Memory of the table's entries.
std::size_t PreIntegratedTableBytes(const OpticalTable& table,
  std::size_t mostEntries = MostPreIntegratedValues * MostPreIntegratedValues);

}

#endif
