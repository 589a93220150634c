#ifndef Varimarch_Readers_Dicom_FileHeader_h
#define Varimarch_Readers_Dicom_FileHeader_h

#include "Readers/Dicom/DicomFrame.h"

#include <vtkDICOMMetaData.h>
#include <vtkSmartPointer.h>

namespace varimarch
{

/// The header of a DICOM file: the attributes before its pixels.
struct DicomHeader
{
  vtkSmartPointer<vtkDICOMMetaData> meta; ///< null if the file is not a DICOM file
  std::shared_ptr<DicomFile> file;        ///< null if the file has no pixels, or has a fault
  int completeFrames = 0;                 ///< number of frames before the end of the file
  std::optional<DicomFault> fault;        ///< reason why all or some of the frames cannot be read
};

/// Reads a header. A fault of the file is in the result.
DicomHeader ReadDicomHeader(const std::string& path);

/// True for pixels that are stored without compression.
bool IsUncompressed(const DicomFile& file);

/// Bytes that the frames need as the file stores them without compression.
double StoredBytes(const DicomFile& file, int frameCount);

}

#endif
