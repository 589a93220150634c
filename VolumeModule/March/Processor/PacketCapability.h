#ifndef Varimarch_March_Processor_PacketCapability_h
#define Varimarch_March_Processor_PacketCapability_h

#include "Frame/Frame.h"
#include "Resources/SceneResources.h"

namespace varimarch
{

/// True if packets of rays should march a frame if they can: where OpenGL is software, unless its
/// memory is bounded, and on any device a frame with shadows or ambient occlusion.
bool ShouldMarchByPackets(const Frame& frame);

/// True if packets of rays can march a frame: the request allows it, and packets have code for the
/// recipe and the voxels of every volume.
/// @param resources  the volumes, with up-to-date voxels
bool CanMarchByPackets(const Frame& frame, SceneResources& resources);

}

#endif
