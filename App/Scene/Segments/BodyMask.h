#ifndef Varimarch_Scene_BodyMask_h
#define Varimarch_Scene_BodyMask_h

#include <vtkImageConnectivityFilter.h>
#include <vtkSmartPointer.h>

#include <string>

class vtkImageData;

namespace varimarch
{

/// True if a body can be told from a table: in CT, whose values have a unit.
/// @param modality  of DICOM, such as "CT"
bool HasBodyMask(const std::string& modality);

/// The body of a CT scan without the table, the head rest, clothes and the air around it. The body
/// is the largest part of the scan that is denser than foam and thicker than 6 mm, with small thin
/// parts beside it such as ears, and with the air that it encloses. Its surface is kept with a
/// margin of about 2 mm, so that it is lit as before.
///
/// Values are those of a mask, see SceneCuts.h: 1 in the body, 0 elsewhere. It is computed on a
/// coarser grid of at most 4 million voxels.
/// @param image  slices along its third axis; the first component is used [HU]
/// @return null if nothing is dense enough
vtkSmartPointer<vtkImageData> BodyMask(vtkImageData* image);

/// A scan of a head without its face: the front half of the head is cut away to a depth behind its
/// surface. The surface is smoothed before, by its deepest place within 20 mm, so that the cut has
/// no nose, lips and eye sockets. What lies deeper than the front half stays, whatever the depth.
///
/// This makes a face hard to recognise in an image of the scan; it is no anonymization. Bones and
/// ears stay, the values beside the cut too, and a scan whose front is not the face loses something
/// else. World space is LPS, in which the front is known.
///
/// Values are those of a mask on the grid of the image, see SceneCuts.h: 1 where the scan stays.
/// The surface is that of -300 HU where values are as low as those of air in CT, else that of 15 %
/// of the range of the values.
/// @param depthMm  > 0
/// @return null if there is no surface
vtkSmartPointer<vtkImageData> FaceMask(vtkImageData* image, double depthMm);

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
