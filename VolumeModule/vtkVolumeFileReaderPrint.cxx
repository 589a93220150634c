// The settings of the reader as text.

#include "vtkVolumeFileReader.h"

void vtkVolumeFileReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << '\n';
  os << indent << "RawDimensions: " << this->RawDimensions[0] << ' ' << this->RawDimensions[1]
     << ' ' << this->RawDimensions[2] << '\n';
  os << indent << "RawScalarType: " << vtkImageScalarTypeNameMacro(this->RawScalarType) << '\n';
  os << indent << "RawNumberOfComponents: " << this->RawNumberOfComponents << '\n';
  os << indent << "RawSpacing: " << this->RawSpacing[0] << ' ' << this->RawSpacing[1] << ' '
     << this->RawSpacing[2] << '\n';
  os << indent << "RawHeaderBytes: " << this->RawHeaderBytes << '\n';
  os << indent << "RawBigEndian: " << this->RawBigEndian << '\n';
  os << indent << "DICOMSeriesUID: " << this->DICOMSeriesUID << '\n';
  os << indent << "DICOMKind: " << this->DICOMKind << '\n';
  os << indent << "RectifySlices: " << this->RectifySlices << '\n';
  os << indent << "RectifyMisplacedSlices: " << this->RectifyMisplacedSlices << '\n';
  os << indent << "MaximumHostMemory: " << this->MaximumHostMemory << '\n';
  os << indent << "PreviewAllowed: " << this->PreviewAllowed << '\n';
  os << indent << "ResolutionLevel: " << this->ResolutionLevel << '\n';
  os << indent << "Channel: " << this->Channel << '\n';
  os << indent << "TimeIndex: " << this->TimeIndex << '\n';
  os << indent << "FilesAreTimes: " << this->FilesAreTimes << '\n';
  os << indent << "LongestSilence: " << this->LongestSilence << '\n';
  os << indent << "ErrorMessage: " << this->ErrorMessage << '\n';
}
