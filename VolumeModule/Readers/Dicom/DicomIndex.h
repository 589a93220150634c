#ifndef Varimarch_Readers_Dicom_DicomIndex_h
#define Varimarch_Readers_Dicom_DicomIndex_h

#include "Readers/VolumeFile.h"

#include <string>
#include <vector>

namespace varimarch
{

/// The files that a DICOMDIR lists.
/// @throws ReadCancelled
std::vector<std::string> FilesOfIndex(const std::string& index, ReadProgress& progress);

}

#endif
