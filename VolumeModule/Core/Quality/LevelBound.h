#ifndef Varimarch_Core_Quality_LevelBound_h
#define Varimarch_Core_Quality_LevelBound_h

#include "Core/Fields/BrickRanges.h"
#include "Core/Geometry/PixelRays.h"
#include "Core/Look/OpticalTable.h"

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>

#include <vector>

namespace varimarch
{

/// A composite that is drawn from a coarser level of a volume instead of its voxels. Cells without
/// a value are clear.
struct LevelBoundScene
{
  const BrickRanges& ranges; ///< ranges of the voxels
  const OpticalTable& table;
  PixelRays rays;
  glm::ivec2 pixels;
  glm::dmat3 worldFromGrid;
  bool isLit; ///< true if light changes colours, to any from 0 to 1
};

/// Bounds of the error of the level, one for each pixel: how far a premultiplied channel or the
/// opacity can be from that of the voxels, [0, 1]. They need no voxel.
///
/// Each voxel of the level must be a mean of voxels of one brick, at the mean of their places. What
/// rays meet in a brick, in the volume and in the level, is then between the extremes of the brick
/// and its neighbours; and between the extremes of any extinction s and colour c between bounds
/// lies the composite, whose change along the ray from behind, dC = s (c - C) dt, is monotone in
/// both.
std::vector<float> LevelBounds(const LevelBoundScene& scene);

}

#endif
