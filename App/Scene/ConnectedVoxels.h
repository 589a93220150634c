#ifndef Varimarch_Scene_ConnectedVoxels_h
#define Varimarch_Scene_ConnectedVoxels_h

#include <vtkImageConnectivityFilter.h>
#include <vtkSmartPointer.h>

class vtkImageData;

namespace varimarch
{

/// A filter of voxels whose values lie in a range and which are connected through faces. Its output
/// has bytes, 1 in the extracted regions and 0 elsewhere. VTK's filter knows no directions, so
/// its voxels and seeds lie at their indices, counted from 0.
vtkSmartPointer<vtkImageConnectivityFilter> NewConnectivity(
  vtkImageData* image, double smallest, double largest);

}

#endif
