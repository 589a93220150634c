#ifndef Varimarch_Readers_VtkImage_h
#define Varimarch_Readers_VtkImage_h

#include "Readers/VolumeFile.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

namespace varimarch
{

/// An array of VTK image data, with values at the points or in the cells.
struct ImageArray
{
  std::string name;
  int scalarType;
  int componentCount;
  bool isActive; ///< the file names it as the scalars
  bool isInCells;
};

/// The array that is shown: points before cells, the active scalars before others, at most four
/// components before more.
/// @throws std::runtime_error if none is numeric
ImageArray ArrayToShow(const std::string& path, std::vector<ImageArray> arrays);

/// An image whose points are voxels with the values of the array. The voxel of a cell is at the
/// cell's centre. Null if the image lacks the array.
vtkSmartPointer<vtkImageData> VoxelsOf(vtkImageData* image, const ImageArray& array);

/// The volume of an image with voxels as points, whose first index becomes 0.
/// @throws std::runtime_error if its geometry is not valid
Volume VolumeOf(const std::string& path, vtkImageData* voxels);

/// Reads a VTI file; the result is that of VoxelsOf.
/// @throws std::runtime_error if the file is not complete
/// @throws ReadCancelled
vtkSmartPointer<vtkImageData> ReadVtiFile(const std::string& path, ReadProgress& progress);

}

#endif
