#ifndef Varimarch_Readers_Dicom_FileSearch_h
#define Varimarch_Readers_Dicom_FileSearch_h

#include "VarimarchVolumeModule.h"

#include "Readers/VolumeFile.h"

#include <string>
#include <vector>

namespace varimarch
{

/// Finds the files that may be DICOM images: those that a DICOMDIR lists, those of a folder and its
/// subfolders, or the file itself. A folder with a DICOMDIR has the files that this lists.
/// @param warnings  receives a sentence if folders are too deep
/// @throws ReadCancelled
VARIMARCHVOLUME_EXPORT std::vector<std::string> FindDicomFiles(
  const std::string& path, std::vector<std::string>& warnings, ReadProgress& progress);

}

#endif
