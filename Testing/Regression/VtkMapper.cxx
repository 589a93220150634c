#include "Regression/VtkMapper.h"

#include "Scene/Model/Scene.h"

#include <vtkOpenGLGPUVolumeRayCastMapper.h>

void UseVtkMapper(const RegressionScene& scene)
{
  for (const std::shared_ptr<MapperScene>& volume : scene.volumes)
  {
    volume->UseMapper(varimarch::MapperKind::VtkGpu);
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
