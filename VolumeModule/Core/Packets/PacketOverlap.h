#ifndef Varimarch_Core_Packets_PacketOverlap_h
#define Varimarch_Core_Packets_PacketOverlap_h

// Volumes that overlap, in one march: Shaders/March/Several.glsl, Volumes/Next.glsl and Reading.

#include "Core/Packets/Lanes.h"
#include "Core/Packets/PacketOptics.h"
#include "Core/Packets/PacketRays.h"
#include "Core/Packets/PacketScene.h"
#include "Core/Packets/PacketWalk.h"

namespace varimarch
{

/// @param first  which has others
/// @param x  and y: of the first pixel of the packet
PacketSum MarchOverlapping(const PacketScene& first, const PacketRays& rays, const PacketWalk& walk,
  const PacketSum& before, int x, int y);

}

#endif
