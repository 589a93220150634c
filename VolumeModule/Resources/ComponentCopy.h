#ifndef Varimarch_Resources_ComponentCopy_h
#define Varimarch_Resources_ComponentCopy_h

#include "Resources/VolumeTexture.h"

#include "VarimarchVolumeModule.h"
#include "vtkSmartPointer.h"

class vtkDataArray;

namespace varimarch
{

/// The numbers of one component of voxels, in memory of their own; 0 for those that are not finite.
struct ComponentCopy
{
  vtkSmartPointer<vtkDataArray> array; ///< An array of one component; null if there is no copy.
  bool allFinite = true;               ///< there were none of these
};

VARIMARCHVOLUME_EXPORT ComponentCopy CopyAsItIs(const VoxelComponent& component);
VARIMARCHVOLUME_EXPORT ComponentCopy CopyAsFloats(const VoxelComponent& component);
ComponentCopy CopyAsDoubles(const VoxelComponent& component);

}

#endif
