#ifndef Varimarch_Readers_Dicom_Metadata_h
#define Varimarch_Readers_Dicom_Metadata_h

#include "Readers/VolumeFile.h"
#include "VarimarchVolumeModule.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace varimarch
{

/// Attributes of a frame that its place and values do not depend on. Most members are those of
/// Volume; all are empty if the file cannot be read.
struct DicomMetadata
{
  std::string modality;
  std::string bodyPart;
  bool hasContrastAgent = false;
  std::string weighting;
  std::optional<WindowLevel> windowLevel;
  bool isInverted = false;
  std::optional<double> uptakeValueFactor;
  std::string uptakeDoubt; ///< the reason why a PET image has no factor; see UptakeValue
};

/// Reads the metadata of a frame.
DicomMetadata MetadataOf(const std::string& path, int frame);

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

/// An attribute of a DICOM file in words. It may identify the patient.
struct DicomTag
{
  int depth = 0;              ///< number of sequences that the attribute lies in
  std::string tag;            ///< "(0010,0010)"; empty for an item of a sequence
  std::string representation; ///< "PN"
  std::string name;           ///< "PatientName"; empty if unknown, as of most private attributes
  /// In UTF-8, without control characters; several values are joined by backslashes. The size of
  /// binary values in place of them if they are long.
  std::string value;
};

/// All attributes of a DICOM file before its pixels, private ones too, in the order of the file;
/// those of a sequence follow it. Texts longer than 10 000 bytes are cut.
/// @throws std::runtime_error if the file is not a DICOM file, or is damaged before its pixels
VARIMARCHVOLUME_EXPORT std::vector<DicomTag> TagsOf(const std::string& path);

/// The files that a DICOMDIR lists.
/// @throws ReadCancelled
std::vector<std::string> FilesOfIndex(const std::string& index, ReadProgress& progress);

}

#endif
