#ifndef Varimarch_Resources_VolumeGaps_h
#define Varimarch_Resources_VolumeGaps_h

#include "Core/Fields/GapField.h"
#include "Frame/VoxelInput.h"
#include "Resources/VolumeTexture.h"

namespace varimarch
{

/// The gaps of a region of a volume.
GapField GapFieldOf(const ScalarRegion& region, const Blanking& blanking);

}

#endif
