#ifndef Varimarch_Core_Packets_Spacing_Uneven_h
#define Varimarch_Core_Packets_Spacing_Uneven_h

// Twin of Spacing/Uneven.glsl.

#include "Core/Packets/PacketScene.h"
#include "Core/Packets/ShaderMath.h"

namespace varimarch
{

namespace
{

/// The places in the grid of the voxels for places in the even grid, in which rays are straight.
inline Lanes3 UnevenPlace(const PacketScene& scene, const Lanes3& grid)
{
  const PacketSpacing& spacing = scene.spacing;
  const glm::vec3& lowerGrid = scene.parameters.spacingLowerGrid;
  const glm::vec3& binsPerGrid = scene.parameters.spacingBinsPerGrid;
  const auto along = [&](Lanes place, int axis)
  {
    const Lanes bin = SpacingBin(place, All(lowerGrid[axis]), All(binsPerGrid[axis]),
      All(float(spacing.firstBins[axis])), All(float(spacing.lastBins[axis])));
    const IntNumbers index(Truncated(bin));
    Four pieces[LaneCount];
    for (int lane = 0; lane < LaneCount; ++lane)
    {
      pieces[lane] = FourAt(&spacing.bins[index.of[lane]].x);
    }
    return UnevenPlace(place, Transposed(pieces));
  };
  return { along(grid.x, 0), along(grid.y, 1), along(grid.z, 2) };
}

}

}

#endif
