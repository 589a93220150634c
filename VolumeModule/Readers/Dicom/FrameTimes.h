#ifndef Varimarch_Readers_Dicom_FrameTimes_h
#define Varimarch_Readers_Dicom_FrameTimes_h

#include "Readers/Dicom/DicomFrame.h"
#include "Readers/VolumeFile.h"

#include <vector>

namespace varimarch
{

/// The times of volumes by a frame of each: those that the files state, else those after the R wave
/// of the heart, else those of acquisition or content, from the first on; numbers if none of these
/// ascend.
/// @param frames  at least one
VolumeTimes TimesOf(const std::vector<const DicomFrame*>& frames);

}

#endif
