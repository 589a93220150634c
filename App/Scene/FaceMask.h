#ifndef Varimarch_Scene_FaceMask_h
#define Varimarch_Scene_FaceMask_h

#include <vtkSmartPointer.h>

class vtkImageData;

namespace varimarch
{

/// A scan of a head without its face: the front half of the head is cut away to a depth behind its
/// surface. The surface is smoothed before, by its deepest place within 20 mm, so that the cut has
/// no nose, lips and eye sockets. What lies deeper than the front half stays, whatever the depth.
///
/// This makes a face hard to recognise in an image of the scan; it is no anonymization. Bones and
/// ears stay, the values beside the cut too, and a scan whose front is not the face loses something
/// else. World space is LPS, in which the front is known.
///
/// Values are those of a mask on the grid of the image, see Scissors.h: 1 where the scan stays.
/// The surface is that of -300 HU where values are as low as those of air in CT, else that of 15 %
/// of the range of the values.
/// @param depthMm  > 0
/// @return null if there is no surface
vtkSmartPointer<vtkImageData> FaceMask(vtkImageData* image, double depthMm);

}

#endif
