#ifndef Varimarch_Resources_ChannelCopy_h
#define Varimarch_Resources_ChannelCopy_h

#include "Resources/VolumeTexture.h"

#include "VarimarchVolumeModule.h"
#include "vtkSmartPointer.h"

class vtkDataArray;

namespace varimarch
{

/// The numbers of one channel of voxels, in memory of their own; 0 for those that are not finite.
struct ChannelCopy
{
  vtkSmartPointer<vtkDataArray> array; ///< of one component; none: there is no copy
  bool allFinite = true;               ///< there were none of these
};

VARIMARCHVOLUME_EXPORT ChannelCopy CopyAsItIs(const VoxelChannel& channel);
VARIMARCHVOLUME_EXPORT ChannelCopy CopyAsFloats(const VoxelChannel& channel);
ChannelCopy CopyAsDoubles(const VoxelChannel& channel);

}

#endif
