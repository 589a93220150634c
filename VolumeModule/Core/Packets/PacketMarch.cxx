#include "Core/Packets/PacketMarch.h"

#include "Core/Packets/PacketTile.h"

#include <tbb/parallel_for.h>

namespace varimarch
{

namespace
{

// Pixels on a side of what one core marches at a time: few enough that all cores finish together,
// and whole packets.
constexpr int TileSide = 16;

}

#ifdef VARIMARCH_PACKETS

bool CanMarchPackets()
{
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
}

void MarchPackets(const PacketScene& scene, const Viewport& pixels, float* rgba)
{
  // Those of the whole picture: a pixel is then in the same packet whatever part is marched.
  const int firstColumn = pixels.left / TileSide;
  const int firstRow = pixels.bottom / TileSide;
  const int columns = (pixels.left + pixels.width + TileSide - 1) / TileSide - firstColumn;
  const int rows = (pixels.bottom + pixels.height + TileSide - 1) / TileSide - firstRow;
  tbb::parallel_for(0, columns * rows,
    [&](int tile)
    {
      const int left = (firstColumn + tile % columns) * TileSide;
      const int bottom = (firstRow + tile / columns) * TileSide;
      MarchTileByAvx2(scene, pixels, { left, bottom, TileSide, TileSide }, rgba);
    });
}

#else

bool CanMarchPackets()
{
  return false;
}

void MarchPackets(const PacketScene&, const Viewport&, float*) {}

#endif

}
