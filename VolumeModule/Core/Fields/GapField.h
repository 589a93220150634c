#ifndef Varimarch_Core_Fields_GapField_h
#define Varimarch_Core_Fields_GapField_h

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace varimarch
{

/// Visibility of a voxel or cell. The values are ordered: a region has the least presence of its
/// parts.
enum class Presence : std::uint8_t
{
  NoValue, ///< its value is not finite
  LeftOut, ///< it has a value but is blanked
  Drawn,
};

/// Presence of the voxels, and optionally the cells, of a part of a volume.
struct PresenceGrid
{
  glm::ivec3 voxelCount;
  std::vector<Presence> voxels; ///< x fastest
  std::vector<Presence> cells;  ///< presence of cells that have flags of their own, or empty
  bool interpolated;            ///< true if a value depends on all voxels around it
};

/// The cells (or voxels) of a volume that have no value or are left out, one byte each:
///   0            at least one value is missing
///   255          left out, whatever its values
///   k + 1        drawn, as are all of c - k ... c + k
struct GapField
{
  static constexpr std::uint8_t NoValue = 0;
  static constexpr std::uint8_t LeftOut = 255;

  glm::ivec3 count = glm::ivec3(0);
  std::vector<std::uint8_t> texels; ///< x fastest
};

/// A field of cells: a cell is drawn if all its voxels are.
GapField BuildGapFieldOfCells(const PresenceGrid& grid);

/// A field of voxels drawn as boxes. With interpolation, the neighbours of a voxel without a value
/// have no value either.
GapField BuildGapFieldOfVoxels(const PresenceGrid& grid);

}

#endif
