#ifndef Varimarch_Readers_Dicom_FramePlaces_h
#define Varimarch_Readers_Dicom_FramePlaces_h

#include "Readers/Dicom/DicomFrame.h"

class vtkDICOMMetaData;

namespace varimarch
{

/// Sets the positions, directions and distances of pixels and slices of a file's frames. Frames
/// without positions of their own are stacked along their normal if the kind of file says so;
/// otherwise they are images of one place at different times.
/// @param frames  the first frames of the file, in order
void PlaceFrames(vtkDICOMMetaData* meta, std::vector<DicomFrame>& frames);

}

#endif
