#ifndef Varimarch_Readers_Dicom_FileFrames_h
#define Varimarch_Readers_Dicom_FileFrames_h

#include "Readers/Dicom/DicomFrame.h"

namespace varimarch
{

/// The images in a file.
struct DicomContent
{
  bool isDicom = false;            ///< false if the file is not a DICOM file
  std::shared_ptr<DicomFile> file; ///< null if the file has no pixels, or has a fault
  /// The complete frames, each with the attributes that it has itself, shares or inherits. A
  /// Siemens mosaic is taken apart.
  std::vector<DicomFrame> frames;
  std::optional<DicomFault> fault; ///< reason why all or some of the frames cannot be read
};

/// Reads the attributes of a file. A fault of the file is in the result.
DicomContent ReadDicomContent(const std::string& path);

}

#endif
