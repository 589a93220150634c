#ifndef Varimarch_Readers_Dicom_Pixels_h
#define Varimarch_Readers_Dicom_Pixels_h

#include "Readers/Dicom/DicomFrame.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

namespace varimarch
{

/// The stored values of all frames of a file, one frame per slice, or the reason why there are
/// none.
struct DecodedPixels
{
  vtkSmartPointer<vtkImageData> image; ///< null if the file cannot be decoded
  std::optional<DicomFault> fault;     ///< set if the image is null
};

/// Decodes a file: vtk-dicom reads uncompressed pixels itself, and compressed ones by GDCM. Stored
/// bits are the lowest ones of each value, with the sign that the header states. Colours are RGB.
DecodedPixels DecodePixels(const DicomFile& file);

}

#endif
