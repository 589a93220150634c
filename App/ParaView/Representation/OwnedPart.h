#ifndef Varimarch_OwnedPart_h
#define Varimarch_OwnedPart_h

#include "vtkSmartPointer.h"

#include <vector>

class vtkDataObject;
class vtkDataSet;
class vtkImageData;

namespace varimarch
{

/// The images and rectilinear grids with points in a data set of several parts, or the data set
/// itself if it is one of them.
std::vector<vtkDataSet*> GridsIn(vtkDataObject* data);

/// True if the axes of the image are those of the world, so that a box of cells is a box there.
bool IsAxisAligned(vtkImageData* image);

/// The image without flags of points and cells that other processes own. Flags of hidden points and
/// cells stay. The voxels are shared.
vtkSmartPointer<vtkImageData> WithoutFlagsOfNeighbours(vtkImageData* image);

}

#endif
