#ifndef Varimarch_Readers_Dicom_Record_h
#define Varimarch_Readers_Dicom_Record_h

#include "VarimarchVolumeModule.h"

#include "Readers/VolumeFile.h"

#include <functional>
#include <string>
#include <vector>

namespace varimarch
{

/// The place of an image in a list of studies. It identifies the patient. Texts are in UTF-8; any
/// may be empty.
struct DicomRecord
{
  std::string patientName; ///< as stored, such as "DOE^JANE"
  std::string patientId;
  std::string studyUid;
  std::string studyDate; ///< as stored, "20261126"
  std::string studyDescription;
  std::string seriesUid; ///< empty if the file is no DICOM image
  int seriesNumber = 0;
  std::string seriesDescription;
  std::string modality;
  std::string imageUid;
};

/// Reads the record of a file.
DicomRecord RecordOf(const std::string& path);

/// Reads the records of files, and passes them on in order. A file that cannot be read has an empty
/// one.
/// @throws ReadCancelled
VARIMARCHVOLUME_EXPORT void ForEachRecord(const std::vector<std::string>& paths,
  const std::function<void(std::size_t, const DicomRecord&)>& take, ReadProgress& progress);

}

#endif
