#ifndef Varimarch_Core_Packets_PacketTile_h
#define Varimarch_Core_Packets_PacketTile_h

#include "Core/Packets/PacketMarch.h"
#include "Core/Packets/PacketScene.h"

namespace varimarch
{

/// The content of a tile: std::int8_t, std::uint8_t, std::int16_t, std::uint16_t or float, which
/// are fewer than 2^31 voxels of this type, or one of these.
struct ManyVoxels; ///< any number of voxels of any of these types
struct SplineCoefficients;
struct Mixture;

/// Marches the pixels in a tile of whole packets on one core. Each set of instructions and each
/// content has a copy of its own in a translation unit of its own, made of PacketTile.cxx.in. Only
/// on a processor that has these instructions may it be called.
/// @param rgba  colours of the pixels, as in MarchPackets
template <InstructionSet Set, class Content>
void MarchTile(const PacketScene& scene, const Viewport& pixels, const Viewport& tile, float* rgba);

}

#endif
