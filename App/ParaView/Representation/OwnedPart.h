#ifndef Varimarch_OwnedPart_h
#define Varimarch_OwnedPart_h

#include "Core/Geometry/Box.h"

#include "vtkSmartPointer.h"

#include <vector>

class vtkDataObject;
class vtkDataSet;
class vtkInformation;

namespace varimarch
{

/// The part of an image or rectilinear grid that this process owns.
struct OwnedPart
{
  vtkSmartPointer<vtkDataSet> data; ///< may have voxels of other processes around the part
  Box box;                          ///< the part, in the coordinates of the data
  bool hasNeighbours = false;       ///< true if there are voxels around the part
};

/// The images and rectilinear grids with points in a data set of several parts, or the data set
/// itself if it is one of them.
std::vector<vtkDataSet*> GridsIn(vtkDataObject* data);

/// The part of a grid that this process owns. The voxels are shared. Flags of hidden points and
/// cells stay, and those of points and cells that other processes own are removed.
OwnedPart PartOf(vtkDataSet* grid);

std::vector<Box> BoxesOf(const std::vector<OwnedPart>& parts);

/// The box around some boxes; `lower` is above `upper` if there are none.
Box BoxAround(const std::vector<Box>& boxes);

/// The pipeline's information about a grid that is not a piece of another.
vtkSmartPointer<vtkInformation> InformationOf(vtkDataSet* grid);

}

#endif
