#ifndef Varimarch_Readers_Dicom_FrameOrder_h
#define Varimarch_Readers_Dicom_FrameOrder_h

#include "Readers/Dicom/DicomFrame.h"

class vtkDICOMMetaData;

namespace varimarch
{

/// Sets the differences of frames that the vectors of a classic file tell, such as the detector of
/// nuclear medicine: one number for each frame (PS3.3 C.8.4.8).
void TakeVectors(vtkDICOMMetaData* meta, std::vector<DicomFrame>& frames);

/// How the frames of a file follow each other that have no positions of their own: their offsets
/// from the first along the normal [mm]. Empty if the frames are images of one place: if the file
/// says that they differ in time, view, angle or kind, and not in their slice; or if it describes a
/// film. Only a file that says nothing of this is stacked because its slices have a distance.
/// @param frames  with their differences and distances, in order; at least one
std::vector<double> OffsetsMm(vtkDICOMMetaData* meta, const std::vector<DicomFrame>& frames);

/// The fault of a file whose frames are the tiles of one plane, as those of whole slides of
/// microscopes are (PS3.3 C.8.12.4).
std::optional<DicomFault> FaultOfTiles(vtkDICOMMetaData* meta, const DicomFile& file);

}

#endif
