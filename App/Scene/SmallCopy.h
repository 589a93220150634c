#ifndef Varimarch_Scene_SmallCopy_h
#define Varimarch_Scene_SmallCopy_h

#include <vtkSmartPointer.h>

class vtkImageData;

namespace varimarch
{

/// A copy of a volume with at most that many voxels along each axis, each the mean of those that it
/// stands for, at the same place in the world. Shares nothing with the volume, of which no more
/// than the voxels are looked at.
vtkSmartPointer<vtkImageData> SmallCopy(vtkImageData* image, int largestSide);

}

#endif
