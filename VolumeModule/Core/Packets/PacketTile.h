#ifndef Varimarch_Core_Packets_PacketTile_h
#define Varimarch_Core_Packets_PacketTile_h

#include "Core/Packets/PacketMarch.h"
#include "Core/Packets/PacketScene.h"

namespace varimarch
{

/// The content of a tile: std::int8_t, std::uint8_t, std::int16_t, std::uint16_t or float, see
/// IsOfOneType, or anything else. Everything can be marched as anything; one type is faster.
struct Anything;

/// True for scenes of one volume that is not a spline, has fewer than 2^31 voxels and dims no
/// light.
inline bool IsOfOneType(const PacketScene& scene)
{
  const bool dims = scene.light.castsShadows || scene.sky.strength > 0.0f || scene.receivers.places;
  return IsIndexedBy32Bits(scene.volume.voxelCount) && !scene.volume.areOfSpline &&
    !scene.constituent.isOfMixture && !dims;
}

/// Marches the pixels in a tile of whole packets on one core. Each set of instructions and each
/// content has a copy of its own in a translation unit of its own, made of PacketTile.cxx.in. Only
/// on a processor that has these instructions may it be called.
/// @param rgba  colours of the pixels, as in MarchPackets
template <InstructionSet Set, class Content>
void MarchTile(const PacketScene& scene, const Viewport& pixels, const Viewport& tile, float* rgba);

}

#endif
