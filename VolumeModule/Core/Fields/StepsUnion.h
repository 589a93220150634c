#ifndef Varimarch_Core_Fields_StepsUnion_h
#define Varimarch_Core_Fields_StepsUnion_h

#include "Core/Fields/BrickRanges.h"

#include <algorithm>

namespace varimarch
{

/// The range of the values of two bricks, or of two parts of a brick.
inline BrickRanges::Steps Union(const BrickRanges::Steps& a, const BrickRanges::Steps& b)
{
  if (!a.IsFinite() || !b.IsFinite())
  {
    return { 1, 0 };
  }
  return { std::min(a.smallest, b.smallest), std::max(a.largest, b.largest) };
}

}

#endif
