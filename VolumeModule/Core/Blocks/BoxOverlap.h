#ifndef Varimarch_Core_Blocks_BoxOverlap_h
#define Varimarch_Core_Blocks_BoxOverlap_h

#include "Core/Geometry/Box.h"

#include <optional>
#include <utility>
#include <vector>

namespace varimarch
{

/// The first two of some boxes that overlap; none if all of them are apart. Boxes that touch are
/// apart, even if rounding lets them overlap by a millionth of their sides.
std::optional<std::pair<int, int>> FirstOverlap(const std::vector<Box>& boxes);

}

#endif
