#ifndef Varimarch_Readers_Dicom_Tags_h
#define Varimarch_Readers_Dicom_Tags_h

#include "VarimarchVolumeModule.h"

#include <string>
#include <vector>

namespace varimarch
{

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

}

#endif
