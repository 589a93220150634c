#ifndef Varimarch_Resources_ChannelCopy_h
#define Varimarch_Resources_ChannelCopy_h

#include "Resources/VolumeTexture.h"

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

ChannelCopy CopyAsItIs(const VoxelChannel& channel);
ChannelCopy CopyAsFloats(const VoxelChannel& channel);
ChannelCopy CopyAsDoubles(const VoxelChannel& channel);

}

#endif
