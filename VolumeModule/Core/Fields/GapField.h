#ifndef Varimarch_Core_Fields_GapField_h
#define Varimarch_Core_Fields_GapField_h

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace varimarch
{

/// Whether a voxel or cell is drawn. Ordered: what touches several is what the least of them is.
enum class Presence : std::uint8_t
{
  NoValue, ///< it is not finite
  LeftOut, ///< it has a value, and is blanked
  Drawn,
};

/// What a part of a volume holds, voxel by voxel.
struct PresenceGrid
{
  glm::ivec3 voxelCount;
  std::vector<Presence> voxels; ///< x fastest
  std::vector<Presence> cells;  ///< between the voxels, for flags of their own; or empty
  bool interpolated;            ///< a value is made of all voxels around it
};

/// The gaps of a volume: one byte for each cell between voxels, or for each voxel:
///   0            a value is missing
///   255          left out, whatever the value
///   k + 1        drawn, and so are all of c - k ... c + k
struct GapField
{
  static constexpr std::uint8_t NoValue = 0;
  static constexpr std::uint8_t LeftOut = 255;

  glm::ivec3 count = glm::ivec3(0);
  std::vector<std::uint8_t> texels; ///< x fastest
};

/// Of cells: one is drawn when all its voxels are.
GapField BuildGapFieldOfCells(const PresenceGrid& grid);

/// Of voxels as boxes. Where values are interpolated, the neighbours of a voxel without a value
/// have none either.
GapField BuildGapFieldOfVoxels(const PresenceGrid& grid);

}

#endif
