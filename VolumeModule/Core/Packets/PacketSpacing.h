#ifndef Varimarch_Core_Packets_PacketSpacing_h
#define Varimarch_Core_Packets_PacketSpacing_h

#include "Core/Packets/Lanes.h"
#include "Core/Packets/PacketScene.h"

namespace varimarch
{

namespace
{

/// Shaders/Spacing/Uneven.glsl: from places in the even grid, in which rays are straight, to places
/// in the grid of the voxels.
inline Lanes3 UnevenPlace(const PacketScene& scene, const Lanes3& grid)
{
  const PacketSpacing& spacing = scene.spacing;
  const glm::vec3& lowerGrid = scene.parameters.spacingLowerGrid;
  const glm::vec3& binsPerGrid = scene.parameters.spacingBinsPerGrid;
  const auto along = [&](Lanes place, int axis)
  {
    const Lanes bin = (place - lowerGrid[axis]) * binsPerGrid[axis];
    const Lanes last = All(float(spacing.lastBins[axis] - spacing.firstBins[axis]));
    const IntNumbers index(Truncated(Clamp(bin, Lanes{}, last)));
    Four pieces[LaneCount];
    for (int lane = 0; lane < LaneCount; ++lane)
    {
      pieces[lane] = FourAt(&spacing.bins[spacing.firstBins[axis] + index.of[lane]].x);
    }
    const Lanes4 piece = Transposed(pieces);
    const Lanes beyond = place - piece.x;
    return piece.y + beyond * Select(LaneMask(beyond < 0.0f), piece.z, piece.w);
  };
  return { along(grid.x, 0), along(grid.y, 1), along(grid.z, 2) };
}

}

}

#endif
