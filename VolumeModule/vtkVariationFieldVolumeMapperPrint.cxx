// The settings of the mapper as text.

#include "vtkVariationFieldVolumeMapper.h"

#include "vtkIndent.h"

void vtkVariationFieldVolumeMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DrawFetchCounts: " << this->DrawFetchCounts << "\n";
  os << indent << "LevelOfDetail: " << this->LevelOfDetail << "\n";
  os << indent << "MaximumHostMemory: " << this->MaximumHostMemory << "\n";
  os << indent << "MaximumGraphicsMemory: " << this->MaximumGraphicsMemory << "\n";
  os << indent << "LightMemoryBytes: " << this->GetLightMemoryBytes() << "\n";
  os << indent << "UsedImageSampleDistance: " << this->GetUsedImageSampleDistance() << "\n";
  os << indent << "RenderToImage: " << this->RenderToImage << "\n";
  os << indent << "DepthImageScalarType: " << this->DepthImageScalarType << "\n";
  os << indent << "ClampDepthToBackface: " << this->ClampDepthToBackface << "\n";
  os << indent << "FinalColorWindow: " << this->FinalColorWindow << "\n";
  os << indent << "FinalColorLevel: " << this->FinalColorLevel << "\n";
  os << indent << "UsedSampleDistance: " << this->GetUsedSampleDistance() << "\n";
  os << indent << "EstimatedError: " << this->GetEstimatedError() << "\n";
}
