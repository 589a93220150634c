#ifndef Varimarch_Readers_Dicom_FileHeader_h
#define Varimarch_Readers_Dicom_FileHeader_h

#include "Readers/Dicom/DicomFrame.h"

#include <vtkDICOMMetaData.h>
#include <vtkSmartPointer.h>

#include <cstdint>

namespace varimarch
{

/// The header of a DICOM file: the attributes before its pixels.
struct DicomHeader
{
  vtkSmartPointer<vtkDICOMMetaData> meta; ///< null if the file is not a DICOM file
  std::shared_ptr<DicomFile> file;        ///< null if the file has no pixels, or has a fault
  std::int64_t pixelOffset = 0;           ///< offset of the first pixel, once inflated [bytes]
  int completeFrames = 0;                 ///< number of frames before the end of the file
  std::optional<DicomFault> fault;        ///< reason why all or some of the frames cannot be read
};

/// Reads a header. A fault of the file is in the result.
DicomHeader ReadDicomHeader(const std::string& path);

}

#endif
