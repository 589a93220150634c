#ifndef Varimarch_Core_Look_PreIntegratedTable_h
#define Varimarch_Core_Look_PreIntegratedTable_h

#include "Core/Look/TransferFunction.h"

#include <vector>

namespace varimarch
{

/// What a transfer function makes of a piece of a ray along which the scalar goes linearly from one
/// value to another: entry (i, j) holds the mean extinction and the mean emission, which is
/// extinction times colour, over the values from i to j, at equal distances of firstValue ...
/// lastValue. Emission, because between two entries a colour would be mixed with that of what is
/// invisible. The
/// mean extinction times the length is the exact optical depth, so no peak of the transfer function
/// falls between two samples. Engel, Kraus, Ertl, "High-quality pre-integrated volume rendering
/// using hardware-accelerated pixel shading" (Graphics Hardware 2001), without the order of colours
/// within a piece: the table then does not depend on its length, and is symmetric.
struct PreIntegratedTable
{
  double firstValue;
  double lastValue;
  int size;                       ///< along each side, >= 2
  std::vector<glm::vec4> entries; ///< (emission, extinction) [1/mm]; size * size
};

/// @param mostEntries  bounds the memory: size * size is at most this, >= 4
PreIntegratedTable BuildPreIntegratedTable(
  const OpticalTable& table, std::size_t mostEntries = 1024 * 1024);

/// What its entries take.
std::size_t PreIntegratedTableBytes(
  const OpticalTable& table, std::size_t mostEntries = 1024 * 1024);

}

#endif
