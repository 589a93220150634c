#ifndef Varimarch_Core_Blocks_BoxOrder_h
#define Varimarch_Core_Blocks_BoxOrder_h

#include "Core/Geometry/Box.h"

#include <glm/vec4.hpp>

#include <optional>
#include <utility>
#include <vector>

namespace varimarch
{

/// The first two of some boxes that overlap; none if all of them are apart. Boxes that touch are
/// apart, even if rounding lets them overlap by a millionth of their sides.
std::optional<std::pair<int, int>> FirstOverlap(const std::vector<Box>& boxes);

/// The indices of boxes that are apart, each after those that may hide a part of it from an eye.
/// Three boxes or more can hide each other in a circle, of which the nearest is then taken first.
/// @param eye  in homogeneous coordinates, at infinity for a parallel projection, where it is the
///             direction towards the eye and w is 0
std::vector<int> FrontToBack(const std::vector<Box>& boxes, const glm::dvec4& eye);

}

#endif
