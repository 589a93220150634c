#ifndef Varimarch_March_Processor_PacketCapability_h
#define Varimarch_March_Processor_PacketCapability_h

#include "Frame/Frame.h"
#include "Resources/SceneResources.h"

namespace varimarch
{

/// Why packets of rays should march a frame instead of shaders.
enum class PacketReason
{
  None,
  SoftwareOpenGL, ///< Packets are faster than the shaders of a software rasteriser.
  Light,          ///< Shaders cannot draw the light: packets march on any device.
};

/// @param isDivided  true if the graphics memory holds the volume only block by block
PacketReason ReasonForPackets(const Frame& frame, bool isDivided);

/// True if packets of rays can march a frame: the request allows it, and packets have code for the
/// recipe and the voxels of every volume.
/// @param resources  the volumes, with up-to-date voxels
bool CanMarchByPackets(const Frame& frame, SceneResources& resources);

}

#endif
