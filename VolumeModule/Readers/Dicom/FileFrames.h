#ifndef Varimarch_Readers_Dicom_FileFrames_h
#define Varimarch_Readers_Dicom_FileFrames_h

#include "Readers/Dicom/FileHeader.h"

namespace varimarch
{

/// The complete frames of a file, each with the attributes that it has itself, shares or inherits.
/// A Siemens mosaic is taken apart; there are no frames if it does not say how many slices it has.
/// @param header  a header with a file
std::vector<DicomFrame> FramesOf(const DicomHeader& header);

}

#endif
