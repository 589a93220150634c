#ifndef Varimarch_March_DenseShadows_h
#define Varimarch_March_DenseShadows_h

#include "Frame/MarchPlan.h"
#include "Resources/MaterialResources.h"

namespace varimarch
{

/// True if a shader draws matter of a volume too dark in its own shadow, whatever the sample
/// distance is. It asks for light in the middle of a sample. Where light and sight end in front of
/// that, the sample is black; so are voxels without interpolation, which have one sample. Packets
/// divide such samples (Core/Packets/Reach/AbsorbingPieces.h).
bool DarkensDenseMatter(const VolumeMarch& march, const MaterialResources& materials);

/// True if a volume with matter of opacity 1 dims light. Such matter ends light within less than
/// any step, so that single pixels at the edges of its shadows may have any light.
bool HasOpaqueMatterInShadow(const Frame& frame);

}

#endif
