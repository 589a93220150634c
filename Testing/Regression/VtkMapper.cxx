#include "Regression/VtkMapper.h"

#include <vtkOpenGLGPUVolumeRayCastMapper.h>
#include <vtkPlaneCollection.h>

namespace
{

void CopyImageSettings(vtkVariationFieldVolumeMapper* from, vtkGPUVolumeRayCastMapper* to)
{
  to->SetAutoAdjustSampleDistances(from->GetAutoAdjustSampleDistances());
  to->SetLockSampleDistanceToInputSpacing(from->GetLockSampleDistanceToInputSpacing());
  to->SetSampleDistance(float(from->GetSampleDistance()));
  to->SetImageSampleDistance(from->GetImageSampleDistance());
  to->SetUseJittering(from->GetUseJittering());
  to->SetFinalColorWindow(from->GetFinalColorWindow());
  to->SetFinalColorLevel(from->GetFinalColorLevel());
  to->SetRenderToImage(from->GetRenderToImage());
}

void CopyVolumeSettings(vtkVariationFieldVolumeMapper* from, vtkGPUVolumeRayCastMapper* to)
{
  to->SetScalarMode(from->GetScalarMode());
  to->SetBlendMode(from->GetBlendMode());
  to->SetAverageIPScalarRange(from->GetAverageIPScalarRange());
  to->SetCropping(from->GetCropping());
  to->SetCroppingRegionPlanes(from->GetCroppingRegionPlanes());
  to->SetCroppingRegionFlags(from->GetCroppingRegionFlags());
  to->SetClippingPlanes(from->GetClippingPlanes());
  to->SetMaskInput(from->GetMaskInput());
  to->SetMaskType(from->GetMaskType());
  to->SetMaskBlendFactor(from->GetMaskBlendFactor());
}

}

void UseVtkMapper(const RegressionScene& scene)
{
  for (const std::shared_ptr<MapperScene>& volume : scene.volumes)
  {
    vtkNew<vtkOpenGLGPUVolumeRayCastMapper> mapper;
    mapper->SetInputDataObject(volume->mapper->GetInputDataObject(0, 0));
    CopyVolumeSettings(volume->mapper, mapper);
    CopyImageSettings(volume->mapper, mapper);
    volume->volume->SetMapper(mapper);
  }
  if (scene.overlap)
  {
    vtkNew<vtkOpenGLGPUVolumeRayCastMapper> mapper;
    for (int port = 0; port < scene.overlap->mapper->GetNumberOfInputPorts(); ++port)
    {
      if (scene.overlap->mapper->GetNumberOfInputConnections(port) > 0)
      {
        mapper->SetInputDataObject(port, scene.overlap->mapper->GetInputDataObject(port, 0));
      }
    }
    scene.overlap->several->SetMapper(mapper);
  }
}
