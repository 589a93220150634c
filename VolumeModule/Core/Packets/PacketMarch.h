#ifndef Varimarch_Core_Packets_PacketMarch_h
#define Varimarch_Core_Packets_PacketMarch_h

#include "Core/Packets/PacketScene.h"

namespace varimarch
{

/// Whether this processor can march packets: it has AVX2 and FMA.
bool CanMarchPackets();

/// Marches rays on all cores of the processor, in packets of eight whose rays go in step: I. Wald,
/// P. Slusallek, C. Benthin, M. Wagner, "Interactive rendering with coherent ray tracing"
/// (Eurographics 2001). What the shaders of VolumeModule/Shaders do, in the same steps, without
/// what a software rasteriser makes of them (Documentation/Decisions/0018).
/// @param pixels  part of the picture
/// @param rgba    premultiplied, of those pixels, from below; 4 * width * height. Or places, where
///                the scene asks for these
void MarchPackets(const PacketScene& scene, const Viewport& pixels, float* rgba);

}

#endif
