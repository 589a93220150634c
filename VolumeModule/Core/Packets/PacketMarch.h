#ifndef Varimarch_Core_Packets_PacketMarch_h
#define Varimarch_Core_Packets_PacketMarch_h

#include "Core/Packets/PacketScene.h"

#include <vector>

namespace varimarch
{

class MarchWork;

/// The sets of instructions that packets are compiled for.
enum class InstructionSet
{
  Baseline, ///< instructions of every processor of the architecture: packets of four rays
  Avx2,     ///< AVX2 and FMA: packets of eight
};

/// The sets that this processor has, the fastest first.
std::vector<InstructionSet> InstructionSetsOfProcessor();

/// Marches rays on all cores of the processor, in packets whose rays advance together: I. Wald,
/// P. Slusallek, C. Benthin, M. Wagner, "Interactive rendering with coherent ray tracing"
/// (Eurographics 2001). They take the same steps as the shaders of VolumeModule/Shaders, without
/// the cost of a software rasteriser (Documentation/Decisions/0018).
/// @param pixels  part of the image
/// @param rgba    premultiplied, of these pixels, the lowest row first; 4 * width * height. Places
///                instead of colours, if the scene asks for these
/// @param set     one that this processor has
/// @param work    may end the march before all pixels are there; null: nothing does
void MarchPackets(const PacketScene& scene, const Viewport& pixels, float* rgba, InstructionSet set,
  MarchWork* work = nullptr);

/// With the fastest set of instructions that this processor has.
void MarchPackets(
  const PacketScene& scene, const Viewport& pixels, float* rgba, MarchWork* work = nullptr);

}

#endif
