#ifndef Varimarch_Scene_GradientMagnitudes_h
#define Varimarch_Scene_GradientMagnitudes_h

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

namespace varimarch
{

/// How steep a volume is, for a histogram: the magnitudes of the gradients [units of the data per
/// mm] at voxels all over it, at most some four million, of the first component, by central
/// differences as the mapper has them. Where a neighbour is not finite, 0.
vtkSmartPointer<vtkImageData> GradientMagnitudes(vtkImageData* image);

}

#endif
