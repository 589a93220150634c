#ifndef Varimarch_Core_Fields_EvenBricks_h
#define Varimarch_Core_Fields_EvenBricks_h

#include "Core/Fields/BrickRanges.h"
#include "Core/Geometry/UnevenAxis.h"

#include <vector>

namespace varimarch
{

/// The bricks of a rectilinear volume's even grid, in which rays are straight: each has the range
/// of all bricks of voxels that reach into it, and the outermost ones that of all beyond.
/// @param ofVoxels  at least one
/// @param axes      three
BrickRanges EvenBricks(const BrickRanges& ofVoxels, const std::vector<UnevenAxis>& axes);

}

#endif
