#ifndef Varimarch_Scene_ConnectedVoxels_h
#define Varimarch_Scene_ConnectedVoxels_h

#include <vtkImageConnectivityFilter.h>
#include <vtkSmartPointer.h>

class vtkImageData;

namespace varimarch
{

/// The numbers in the output of NewConnectivity. With bytes, VTK's filter would drop regions beyond
/// the 255th.
using RegionNumber = unsigned short;

/// A filter of voxels whose values lie in a range and which are connected through faces. Its output
/// is 1 in the extracted regions and 0 elsewhere. VTK's filter knows no directions, so its voxels
/// and seeds lie at their indices, counted from 0.
vtkSmartPointer<vtkImageConnectivityFilter> NewConnectivity(
  vtkImageData* image, double smallest, double largest);

}

#endif
