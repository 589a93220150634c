#ifndef Varimarch_Readers_Dicom_ValueMaps_h
#define Varimarch_Readers_Dicom_ValueMaps_h

#include "Readers/Dicom/Attributes.h"
#include "Readers/Dicom/DicomFrame.h"

namespace varimarch
{

/// Takes the map from stored to physical values of a frame: the modality's slope and intercept, or
/// its table, or the scale of a dose; a real-world value map if the file has none of these. A
/// real-world map that is not applied is named. Takes the padding too.
void TakeValueMap(const DicomAttributes& attributes, DicomFrame& frame);

}

#endif
