#ifndef Varimarch_Core_Quality_LevelBound_h
#define Varimarch_Core_Quality_LevelBound_h

#include "Core/Geometry/PixelRays.h"
#include "Core/Quality/BlockLooks.h"
#include "Core/Quality/LightBound.h"

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>

#include <cstddef>
#include <limits>
#include <vector>

namespace varimarch
{

/// A composite of which blocks of bricks are drawn from coarser levels instead of the voxels.
struct LevelBoundScene
{
  const BlockLooks& looks;
  PixelRays rays;
  glm::ivec2 pixels;
  glm::dmat3 worldFromGrid;
  Box boxGrid; ///< The box of the volume, outside of which rays meet nothing.
  /// True if the coarsest level ends at its outermost means, before the faces of the volume.
  bool endsEarlier;
  /// The lights that cast shadows, with the part that surfaces lack; none without shadows.
  std::vector<LevelLight> lights = {};
};

/// Bounds of the error of the levels of blocks, one for each pixel: how far a premultiplied channel
/// or the opacity can be from that of the voxels, [0, 1], where colours above 1 count as 1. They
/// need no voxel.
///
/// Along a ray from behind, the composite C of extinction s and colour c has dC = s (c - C) dt.
/// Between bounds of s and c it is monotone in both, so that the composites of extremes hold all
/// others between them. Two composites of the same voxels approach each other by the transmittance;
/// where s and c differ, their difference D obeys
///   |dD| <= (s |dc| + |ds| |c - C| - s |D|) dt.
/// The smaller of both bounds counts. In blocks of voxels c is the same but for the light that
/// reaches them, see LightBounds.
std::vector<double> LevelBounds(const LevelBoundScene& scene, const BlockLevels& levels);

/// The aim of a round of refinement.
struct RefinementRound
{
  double tolerance; ///< the bound that each pixel gets
  /// Number of blocks after which rows of pixels wait for the next round.
  std::size_t mostBlocks = std::numeric_limits<std::size_t>::max();
};

/// Takes the next finer levels for those blocks that contribute most to the bounds, until none
/// exceeds the tolerance, and for blocks towards lights that these need. Others stay coarse: those
/// that are clear, of one material, or hidden.
/// @param bounds  those of all pixels, as far as they are known, or 1; receives those of the new
/// levels
void Refine(const LevelBoundScene& scene, const RefinementRound& round, BlockLevels& levels,
  std::vector<double>& bounds);

}

#endif
