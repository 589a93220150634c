#ifndef Varimarch_Readers_Dicom_StoredSlices_h
#define Varimarch_Readers_Dicom_StoredSlices_h

#include "Readers/Dicom/Grouping.h"
#include "Readers/VolumeFile.h"

namespace varimarch
{

/// A volume of stored values, and its slices.
struct StoredSlices
{
  DicomSlices slices; ///< the slices that could be decoded
  vtkSmartPointer<vtkImageData> image;
  std::vector<DicomFault> faults; ///< files whose slices are missing
};

/// Decodes slices, file by file.
/// @param path  path for error messages
/// @throws std::runtime_error if the volume does not fit in memory, or no slice can be decoded
/// @throws ReadCancelled
StoredSlices DecodedSlices(
  const std::string& path, const DicomSlices& slices, ReadProgress& progress);

}

#endif
