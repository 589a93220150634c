#ifndef Varimarch_Core_Quality_LightBound_h
#define Varimarch_Core_Quality_LightBound_h

#include "Core/Quality/BlockLooks.h"

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace varimarch
{

/// The place of a lamp near a volume.
struct LampPlace
{
  glm::dvec3 placeGrid;
  glm::dmat3 worldFromGrid; ///< lengths in mm
};

/// Light that matter may keep from a place: that of a lamp at infinity, that of a lamp near the
/// volume, or that of a direction of ambient occlusion, which comes from within a reach.
struct LevelLight
{
  glm::dvec3 towardsGrid; ///< per mm; not used for a lamp near the volume
  double strength;        ///< the largest number that it makes of a colour of at most 1
  double reachMm = std::numeric_limits<double>::infinity();
  std::optional<LampPlace> lamp = std::nullopt; ///< empty for light from a direction

  bool IsFromInfinity() const { return !this->lamp && std::isinf(this->reachMm); }
};

/// Bounds of what the levels of blocks change in the light of places, for each block: how far a
/// colour in it can be from its colour by the light through voxels. They hold for all places in a
/// block and in those around it, between which a march may interpolate light. They need no voxel.
///
/// Rays to a light are sheared into columns: each ray stays in one of them, and crosses a slab of
/// blocks in a known length. In a slab whose extinctions are at least s and differ by at most v
/// between the levels, over the length l, the difference D of the transmittances behind becomes
///   D' <= exp(-s l) (D + 1 - exp(-v l)).
/// Rays to a lamp near the volume, and those that end at a reach, have no columns: each block has a
/// bound of its own for them, see LightPaths, if it is drawn by voxels or beside such a block.
std::vector<double> LightBounds(
  const BlockLooks& looks, const BlockLevels& levels, const std::vector<LevelLight>& lights);

/// Takes finer levels for blocks that lie between some blocks and lights, those first that change
/// most, until the bounds of these blocks are at most the tolerance.
/// @param isLit       not 0 for the blocks whose light counts
/// @param mostBlocks  number of taken blocks after which the others wait for a further call
/// @return the number of taken blocks
std::size_t RefineLight(const BlockLooks& looks, const std::vector<LevelLight>& lights,
  const std::vector<std::uint8_t>& isLit, double tolerance, std::size_t mostBlocks,
  BlockLevels& levels);

}

#endif
