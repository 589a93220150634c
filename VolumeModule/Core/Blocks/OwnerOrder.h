#ifndef Varimarch_Core_Blocks_OwnerOrder_h
#define Varimarch_Core_Blocks_OwnerOrder_h

#include "Core/Geometry/Box.h"

#include <glm/mat4x4.hpp>

#include <optional>
#include <utility>
#include <vector>

namespace varimarch
{

/// A box that is drawn into the picture of its owner. The pictures of owners are laid over each
/// other as a whole.
struct OwnedBox
{
  Box box;                  ///< in the coordinates of its data
  glm::dmat4 worldFromData; ///< affine
  int owner;                ///< counted from 0
};

struct OwnerOrder
{
  std::vector<int> owners; ///< all owners, front to back
  /// Two owners in this order of which the second may hide a part of the first; none if the order
  /// is right. No order is right if boxes overlap, or if two owners may each hide a part of the
  /// other.
  std::optional<std::pair<int, int>> conflict;
};

/// The order of owners in which the fewest pixels may be wrong.
OwnerOrder OwnersFrontToBack(
  const std::vector<OwnedBox>& boxes, int ownerCount, const glm::dmat4& clipFromWorld);

/// The first two of some boxes that overlap; none if all of them are apart. Boxes that touch are
/// apart, even if rounding lets them overlap by a millionth of their sides.
std::optional<std::pair<int, int>> FirstOverlap(const std::vector<Box>& boxes);

}

#endif
