#ifndef Varimarch_Readers_Dicom_JoinedSeries_h
#define Varimarch_Readers_Dicom_JoinedSeries_h

#include "Readers/Dicom/DicomSeries.h"

namespace varimarch
{

/// Joins series of a single image each that are the slices of one volume, as some programs write
/// them: they have one number, modality, description, space, size, pixel size and direction, and
/// lie at different places.
/// @param warnings  receives a sentence about those that were joined
void JoinSingleImages(std::vector<DicomSeries>& all, std::vector<std::string>& warnings);

}

#endif
