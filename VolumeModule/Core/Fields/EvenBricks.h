#ifndef Varimarch_Core_Fields_EvenBricks_h
#define Varimarch_Core_Fields_EvenBricks_h

#include "Core/Fields/BrickRanges.h"
#include "Core/Geometry/UnevenAxis.h"

#include <vector>

namespace varimarch
{

/// Brick ranges on the even grid of a rectilinear volume, in which rays are straight. Each even
/// brick has the range of all voxel bricks that overlap it; outermost ones include everything
/// beyond.
/// @param ofVoxels  ranges of the bricks of voxels; at least one brick
/// @param axes  the three axes
BrickRanges EvenBricks(const BrickRanges& ofVoxels, const std::vector<UnevenAxis>& axes);

}

#endif
