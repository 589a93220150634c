#ifndef Varimarch_OwnedPart_h
#define Varimarch_OwnedPart_h

#include "vtkSmartPointer.h"

class vtkImageData;

namespace varimarch
{

/// True if the axes of the image are those of the world, so that a box of cells is a box there.
bool IsAxisAligned(vtkImageData* image);

/// The image without flags of points and cells that other processes own. Flags of hidden points and
/// cells stay. The voxels are shared.
vtkSmartPointer<vtkImageData> WithoutFlagsOfNeighbours(vtkImageData* image);

}

#endif
