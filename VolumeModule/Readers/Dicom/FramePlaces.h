#ifndef Varimarch_Readers_Dicom_FramePlaces_h
#define Varimarch_Readers_Dicom_FramePlaces_h

#include "Readers/Dicom/DicomFrame.h"

class vtkDICOMMetaData;

namespace varimarch
{

/// Sets the positions, directions and distances of pixels and slices of a file's frames. Frames
/// without positions of their own are stacked along their normal as OffsetsMm says, or else are
/// images of one place. Radiographs without positions are views, not slices.
/// @param frames  the first frames of the file, in order
void PlaceFrames(vtkDICOMMetaData* meta, std::vector<DicomFrame>& frames);

}

#endif
