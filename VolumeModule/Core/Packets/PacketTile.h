#ifndef Varimarch_Core_Packets_PacketTile_h
#define Varimarch_Core_Packets_PacketTile_h

#include "Core/Packets/PacketScene.h"

namespace varimarch
{

/// Marches those of the pixels that are in a tile of whole packets, on one core, which has AVX2 and
/// FMA.
/// @param rgba  of the pixels, as in MarchPackets
void MarchTileByAvx2(
  const PacketScene& scene, const Viewport& pixels, const Viewport& tile, float* rgba);

}

#endif
