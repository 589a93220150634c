#ifndef Varimarch_Core_Quality_LightPaths_h
#define Varimarch_Core_Quality_LightPaths_h

#include "Core/Quality/LightBound.h"
#include "Core/Quality/LightSlabs.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace varimarch
{

/// The matter between single blocks and a lamp near the volume, or within the reach of light from a
/// direction. Rays from all places of a block are at most half a block away from the ray from its
/// middle, along each axis, so that they pass the eight blocks around the corner next to that ray.
class LightPaths
{
public:
  /// @param matters  that of each block; kept by reference, as the levels are
  LightPaths(const BlockLevels& levels, const std::vector<Matter>& matters, const LevelLight& light)
    : levels(levels)
    , matters(matters)
    , light(light)
  {
  }

  /// A bound of what levels change in the part of the light that reaches places of a block.
  double ChangeAt(const glm::ivec3& block) const;

  /// Adds the blocks around the part of the way that changes most, until the others change at most
  /// half of the tolerance.
  void AddWorst(const glm::ivec3& block, double tolerance, std::vector<std::size_t>& places) const;

private:
  /// A part of the way next to a corner.
  struct Part
  {
    glm::ivec3 corner; ///< number of the block above it along each axis
    double change;     ///< the most that it changes in the light
  };

  /// Calls visit(Part) for all parts that change anything, from the block on.
  /// @return the part of the light that comes through them
  template <class Visit>
  double ForEachPart(const glm::ivec3& block, Visit visit) const;
  /// Calls visit(place) for the blocks around a corner, as far as they are in the volume.
  template <class Visit>
  void ForEachAround(const glm::ivec3& corner, Visit visit) const;
  Matter MatterAround(const glm::ivec3& corner) const;

  const BlockLevels& levels;
  const std::vector<Matter>& matters;
  const LevelLight& light;
};

}

#endif
