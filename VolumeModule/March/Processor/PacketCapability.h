#ifndef Varimarch_March_Processor_PacketCapability_h
#define Varimarch_March_Processor_PacketCapability_h

#include "Frame/Frame.h"
#include "Resources/SceneResources.h"

namespace varimarch
{

/// True if packets of rays can march a frame: the request allows it, OpenGL is software, and
/// packets have code for the recipe and the voxels of every volume. Everything else is left to
/// shaders, which have every feature.
/// @param resources  the volumes, with up-to-date voxels
bool CanMarchByPackets(const Frame& frame, SceneResources& resources);

}

#endif
