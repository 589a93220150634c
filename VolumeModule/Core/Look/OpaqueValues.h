#ifndef Varimarch_Core_Look_OpaqueValues_h
#define Varimarch_Core_Look_OpaqueValues_h

#include "Core/Look/TransferFunction.h"
#include "Core/Look/ValueRange.h"

#include <vector>

namespace varimarch
{

/// The ranges of values at which a function is opaque, ascending; an end is infinite if the
/// function stays opaque. A single opaque value among others that are not, as the tip of a tent, is
/// none: light passes it.
/// @param values  the values that occur: a range of which all or none occur is left out, since
///                opaque matter has no border then
std::vector<ValueRange> OpaqueValues(
  const TransferFunction& transferFunction, const ValueRange& values);

}

#endif
