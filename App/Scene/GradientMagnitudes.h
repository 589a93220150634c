#ifndef Varimarch_Scene_GradientMagnitudes_h
#define Varimarch_Scene_GradientMagnitudes_h

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

namespace varimarch
{

/// Gradient magnitudes of a volume's first component [units of the data per mm], for a histogram.
/// They are taken at up to about four million voxels spread over the volume, by the mapper's
/// central differences. A voxel with a neighbour that is not finite gets 0.
vtkSmartPointer<vtkImageData> GradientMagnitudes(vtkImageData* image);

/// Distance between the voxels that have magnitudes, along each axis [voxels].
vtkIdType StrideOfMagnitudes(vtkImageData* image);

}

#endif
