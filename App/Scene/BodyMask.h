#ifndef Varimarch_Scene_BodyMask_h
#define Varimarch_Scene_BodyMask_h

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
/// Values are those of a mask, see Scissors.h: 1 in the body, 0 elsewhere. It is computed on a
/// coarser grid of at most 4 million voxels.
/// @param image  slices along its third axis; the first component is used [HU]
/// @return null if nothing is dense enough
vtkSmartPointer<vtkImageData> BodyMask(vtkImageData* image);

}

#endif
