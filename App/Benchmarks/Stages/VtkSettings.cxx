#include "Stages/VtkSettings.h"

#include <vtkDataObject.h>
#include <vtkFixedPointVolumeRayCastMapper.h>
#include <vtkGPUVolumeRayCastMapper.h>
#include <vtkImageData.h>
#include <vtkPlaneCollection.h>
#include <vtkVariationFieldVolumeMapper.h>

namespace varimarch
{

namespace
{

void CopyOfEveryMapper(vtkVariationFieldVolumeMapper* from, vtkVolumeMapper* to)
{
  to->SetInputDataObject(from->GetInputDataObject(0, 0));
  to->SetScalarMode(from->GetScalarMode());
  to->SetBlendMode(from->GetBlendMode());
  to->SetAverageIPScalarRange(from->GetAverageIPScalarRange());
  to->SetCropping(from->GetCropping());
  to->SetCroppingRegionPlanes(from->GetCroppingRegionPlanes());
  to->SetCroppingRegionFlags(from->GetCroppingRegionFlags());
  to->SetClippingPlanes(from->GetClippingPlanes());
}

}

void CopySettings(vtkVariationFieldVolumeMapper* from, vtkGPUVolumeRayCastMapper* to)
{
  CopyOfEveryMapper(from, to);
  to->SetMaskInput(from->GetMaskInput());
  to->SetMaskType(from->GetMaskType());
  to->SetMaskBlendFactor(from->GetMaskBlendFactor());
  to->SetAutoAdjustSampleDistances(from->GetAutoAdjustSampleDistances());
  to->SetLockSampleDistanceToInputSpacing(from->GetLockSampleDistanceToInputSpacing());
  to->SetSampleDistance(float(from->GetSampleDistance()));
  to->SetImageSampleDistance(from->GetImageSampleDistance());
  to->SetUseJittering(from->GetUseJittering());
  to->SetFinalColorWindow(from->GetFinalColorWindow());
  to->SetFinalColorLevel(from->GetFinalColorLevel());
  to->SetRenderToImage(from->GetRenderToImage());
}

void CopySettings(vtkVariationFieldVolumeMapper* from, vtkFixedPointVolumeRayCastMapper* to)
{
  CopyOfEveryMapper(from, to);
  // By default this mapper adapts its rays to a frame rate, and samples every millimetre.
  to->AutoAdjustSampleDistancesOff();
  to->SetLockSampleDistanceToInputSpacing(from->GetAutoAdjustSampleDistances());
  to->SetSampleDistance(float(from->GetSampleDistance()));
}

}
