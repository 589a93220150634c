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
  const VolumeParameters& p = scene.parameters;
  const auto along = [&](Lanes place, int axis)
  {
    const Lanes bin = SpacingBin(place, All(p.spacingLowerGrid[axis]),
      All(p.spacingBinsPerGrid[axis]), All(p.spacingFirstBins[axis]), All(p.spacingLastBins[axis]));
    const IntNumbers index(Truncated(bin));
    Four pieces[LaneCount];
    for (int lane = 0; lane < LaneCount; ++lane)
    {
      pieces[lane] = FourAt(&scene.textures.spacingTable[index.of[lane]].x);
    }
    return UnevenPlace(place, Transposed(pieces));
  };
  return { along(grid.x, 0), along(grid.y, 1), along(grid.z, 2) };
}

}

}

#endif
