#ifndef Varimarch_Core_Packets_PacketMixture_h
#define Varimarch_Core_Packets_PacketMixture_h

// Several components of a volume, and volumes that overlap, in one march: Shaders/Components and
// Material/Components.glsl; March/Several.glsl and Volumes/Next.glsl, but by midpoints.

#include "Core/Packets/Lanes.h"
#include "Core/Packets/PacketOptics.h"
#include "Core/Packets/PacketRays.h"
#include "Core/Packets/PacketScene.h"
#include "Core/Packets/PacketWalk.h"

namespace varimarch
{

/// @param first  its first part
/// @param x  and y: of the first pixel of the packet
PacketSum MarchMixture(const PacketScene& first, const PacketRays& rays, const PacketWalk& walk,
  const PacketSum& before, int x, int y);

}

#endif
