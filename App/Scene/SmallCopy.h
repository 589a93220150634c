#ifndef Varimarch_Scene_SmallCopy_h
#define Varimarch_Scene_SmallCopy_h

#include <vtkSmartPointer.h>

class vtkImageData;

namespace varimarch
{

/// A reduced copy of a volume, at the same place in the world, with at most `largestSide` voxels
/// along each axis. Each voxel is the mean of those that it replaces. The copy shares no data with
/// the volume and reads only its voxels.
vtkSmartPointer<vtkImageData> SmallCopy(vtkImageData* image, int largestSide);

}

#endif
