#ifndef Varimarch_Core_Packets_PacketImages_h
#define Varimarch_Core_Packets_PacketImages_h

#include "Core/Packets/PacketScene.h"

#include <vector>

namespace varimarch
{

/// One of several images of the same rays.
struct PacketImage
{
  const PacketScene* scene;
  float* rgba; ///< See MarchPackets.
};

/// Marches several images as MarchPackets does, each packet of rays through all of them before the
/// next: voxels that do not fit in memory are read for all images at once.
/// @param pixels  part of each image
void MarchPacketsTogether(const std::vector<PacketImage>& images, const Viewport& pixels);

}

#endif
