#ifndef Varimarch_Scene_ZarrLevels_h
#define Varimarch_Scene_ZarrLevels_h

#include "Scene/VolumeWriters/ZarrFolder.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace varimarch
{

using ZarrIndex = std::array<std::int64_t, 3>;

/// Voxels of a written chunk along each axis.
constexpr std::int64_t ZarrChunkSide = 64;

/// A level of a written pyramid.
struct ZarrLevel
{
  ZarrIndex dimensions;
  ZarrIndex factors; ///< voxels of the level before per voxel along each axis, 1 or 2
};

/// The levels from fine to coarse. The last is a single chunk.
std::vector<ZarrLevel> ZarrLevelsOf(const ZarrIndex& dimensions);

/// Chunks along an axis.
std::int64_t ZarrChunkCount(std::int64_t voxels);

/// The voxels of a chunk that lie in its level, densely.
struct ZarrBlock
{
  ZarrIndex size;
  std::vector<char> voxels;
};

/// Puts the mean of each group of a child's voxels at its place in a coarser block; for labels the
/// first voxel of the group.
/// @param place  first voxel in the coarser block
void PutCoarse(const ZarrInput& input, const ZarrBlock& child, const ZarrIndex& factors,
  const ZarrIndex& place, ZarrBlock& block);

/// The description of an array.
nlohmann::ordered_json ZarrArrayJson(const ZarrInput& input, const ZarrLevel& level);

/// The metadata of OME-Zarr 0.4.
nlohmann::ordered_json ZarrAttributes(const ZarrInput& input, const std::vector<ZarrLevel>& levels);

}

#endif
