#ifndef Varimarch_Resources_ComponentCopy_h
#define Varimarch_Resources_ComponentCopy_h

#include "Resources/VolumeTexture.h"

#include "VarimarchVolumeModule.h"
#include "vtkSmartPointer.h"

class vtkDataArray;

namespace varimarch
{

/// A copy of one component of the voxels, in which non-finite values are 0.
struct ComponentCopy
{
  vtkSmartPointer<vtkDataArray> array; ///< An array of one component; null if there is no copy.
  bool allFinite = true;               ///< True if all values were finite.
};

VARIMARCHVOLUME_EXPORT ComponentCopy CopyAsItIs(const VoxelComponent& component);
VARIMARCHVOLUME_EXPORT ComponentCopy CopyAsFloats(const VoxelComponent& component);
/// Copies scalars as floats by a mapping, limited to +-LargestTexel.
ComponentCopy CopyAsTexels(const VoxelComponent& component, const TexelMapping& mapping);
ComponentCopy CopyAsDoubles(const VoxelComponent& component);

}

#endif
