// vtkVariationFieldVolumeMapper::PrintSelf, apart from the rest for its length.

#include "vtkVariationFieldVolumeMapper.h"

#include "vtkImageData.h"
#include "vtkIndent.h"

void vtkVariationFieldVolumeMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "AccelerationMode: " << this->AccelerationMode << "\n";
  os << indent << "ProcessorMarching: " << this->ProcessorMarching << "\n";
  os << indent << "IntegrationRule: " << this->IntegrationRule << "\n";
  os << indent << "DrawFetchCounts: " << this->DrawFetchCounts << "\n";
  os << indent << "VariationTolerance: " << this->VariationTolerance << "\n";
  os << indent << "SampleDistance: " << this->SampleDistance << "\n";
  os << indent << "SampleDistanceInVoxels: " << this->SampleDistanceInVoxels << "\n";
  os << indent << "MaximumNumberOfSteps: " << this->MaximumNumberOfSteps << "\n";
  os << indent << "FirstDistance: " << this->FirstDistance << "\n";
  os << indent << "AutoAdjustSampleDistances: " << this->AutoAdjustSampleDistances << "\n";
  os << indent << "LockSampleDistanceToInputSpacing: " << this->LockSampleDistanceToInputSpacing
     << "\n";
  os << indent << "EarlyTerminationTransmittance: " << this->EarlyTerminationTransmittance << "\n";
  os << indent << "NanColor: " << this->NanColor[0] << ", " << this->NanColor[1] << ", "
     << this->NanColor[2] << "\n";
  os << indent << "NanOpacity: " << this->NanOpacity << "\n";
  os << indent << "ErrorTolerance: " << this->ErrorTolerance << "\n";
  os << indent << "LevelOfDetail: " << this->LevelOfDetail << "\n";
  os << indent << "MaximumHostMemory: " << this->MaximumHostMemory << "\n";
  os << indent << "MaximumGraphicsMemory: " << this->MaximumGraphicsMemory << "\n";
  os << indent << "CompositingOrder: " << this->CompositingOrder << "\n";
  os << indent << "DampingGradient: " << this->DampingGradient << "\n";
  os << indent << "Shadows: " << (this->Shadows ? "On" : "Off") << "\n";
  os << indent << "ShadowStrength: " << this->ShadowStrength << "\n";
  os << indent << "VolumetricScatteringBlending: " << this->VolumetricScatteringBlending << "\n";
  os << indent << "GlobalIlluminationReach: " << this->GlobalIlluminationReach << "\n";
  os << indent << "ScatteringAnisotropy: " << this->ScatteringAnisotropy << "\n";
  os << indent << "AmbientOcclusion: " << this->AmbientOcclusion << "\n";
  os << indent << "AmbientOcclusionReach: " << this->AmbientOcclusionReach << "\n";
  os << indent << "LightMemoryBytes: " << this->GetLightMemoryBytes() << "\n";
  os << indent << "CubicInterpolation: " << this->CubicInterpolation << "\n";
  os << indent << "StoredGradients: " << this->StoredGradients << "\n";
  os << indent << "UseJittering: " << this->UseJittering << "\n";
  os << indent << "ImageSampleDistance: " << this->ImageSampleDistance << "\n";
  os << indent << "MinimumImageSampleDistance: " << this->MinimumImageSampleDistance << "\n";
  os << indent << "MaximumImageSampleDistance: " << this->MaximumImageSampleDistance << "\n";
  os << indent << "MaximumAccumulatedPictures: " << this->MaximumAccumulatedPictures << "\n";
  os << indent << "LongestPartSeconds: " << this->LongestPartSeconds << "\n";
  os << indent << "UsedImageSampleDistance: " << this->GetUsedImageSampleDistance() << "\n";
  os << indent << "RenderToImage: " << this->RenderToImage << "\n";
  os << indent << "DepthImageScalarType: " << this->DepthImageScalarType << "\n";
  os << indent << "ClampDepthToBackface: " << this->ClampDepthToBackface << "\n";
  os << indent << "FinalColorWindow: " << this->FinalColorWindow << "\n";
  os << indent << "FinalColorLevel: " << this->FinalColorLevel << "\n";
  os << indent << "MaskInput: " << this->MaskInput << "\n";
  os << indent << "MaskType: " << this->MaskType << "\n";
  os << indent << "MaskBlendFactor: " << this->MaskBlendFactor << "\n";
  os << indent << "LabelSurfaces: " << this->LabelSurfaces << "\n";
  os << indent << "Transfer2DYAxisArray: "
     << (this->Transfer2DYAxisArray ? this->Transfer2DYAxisArray : "none") << "\n";
  os << indent << "UsedSampleDistance: " << this->GetUsedSampleDistance() << "\n";
  os << indent << "EstimatedError: " << this->GetEstimatedError() << "\n";
}
