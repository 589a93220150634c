#ifndef Varimarch_Readers_Dicom_SeriesWindow_h
#define Varimarch_Readers_Dicom_SeriesWindow_h

#include "Readers/Dicom/DicomFrame.h"
#include "Readers/VolumeFile.h"

#include <optional>
#include <vector>

namespace varimarch
{

/// The window and level for all images of a series: the median of those that some of its images
/// recommend. Scanners for MR and PET write another window into each image; where the images
/// disagree, and where they recommend none, it is empty, and the values decide.
std::optional<WindowLevel> WindowOfSeries(const std::vector<DicomFrame>& frames);

}

#endif
