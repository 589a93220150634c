#ifndef Varimarch_Readers_Dicom_Metadata_h
#define Varimarch_Readers_Dicom_Metadata_h

#include "Readers/VolumeFile.h"

#include <optional>
#include <string>

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

}

#endif
