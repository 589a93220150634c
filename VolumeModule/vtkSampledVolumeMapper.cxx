#include "vtkSampledVolumeMapper.h"

#include "vtkIndent.h"

void vtkSampledVolumeMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "AccelerationMode: " << this->AccelerationMode << "\n";
  os << indent << "ProcessorMarching: " << this->ProcessorMarching << "\n";
  os << indent << "IntegrationRule: " << this->IntegrationRule << "\n";
  os << indent << "VariationTolerance: " << this->VariationTolerance << "\n";
  os << indent << "SampleDistance: " << this->SampleDistance << "\n";
  os << indent << "SampleDistanceInVoxels: " << this->SampleDistanceInVoxels << "\n";
  os << indent << "MaximumNumberOfSteps: " << this->MaximumNumberOfSteps << "\n";
  os << indent << "FirstDistance: " << this->FirstDistance << "\n";
  os << indent << "AutoAdjustSampleDistances: " << this->AutoAdjustSampleDistances << "\n";
  os << indent << "LockSampleDistanceToInputSpacing: " << this->LockSampleDistanceToInputSpacing
     << "\n";
  os << indent << "EarlyTerminationTransmittance: " << this->EarlyTerminationTransmittance << "\n";
  os << indent << "ErrorTolerance: " << this->ErrorTolerance << "\n";
  os << indent << "CompositingOrder: " << this->CompositingOrder << "\n";
  os << indent << "CubicInterpolation: " << this->CubicInterpolation << "\n";
  os << indent << "StoredGradients: " << this->StoredGradients << "\n";
  os << indent << "UseJittering: " << this->UseJittering << "\n";
  os << indent << "ImageSampleDistance: " << this->ImageSampleDistance << "\n";
  os << indent << "MinimumImageSampleDistance: " << this->MinimumImageSampleDistance << "\n";
  os << indent << "MaximumImageSampleDistance: " << this->MaximumImageSampleDistance << "\n";
  os << indent << "MaximumAccumulatedPictures: " << this->MaximumAccumulatedPictures << "\n";
  os << indent << "LongestPartSeconds: " << this->LongestPartSeconds << "\n";
}
