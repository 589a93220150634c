// VTK's mapper with a tenth of its step size. It is closer to the limit of both mappers, and shows
// which of them is off. The driver registers it if the environment variable REFINED_VTK is set.

#include "RefinedMapper.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLGPUVolumeRayCastMapper.h>
#include <vtkVersion.h>

#include <algorithm>
#include <cstdlib>

namespace
{

constexpr double PartOfStep = 0.1;

class vtkRefinedMapper : public vtkOpenGLGPUVolumeRayCastMapper
{
public:
  static vtkRefinedMapper* New();
  vtkTypeMacro(vtkRefinedMapper, vtkOpenGLGPUVolumeRayCastMapper);

protected:
  void GPURender(vtkRenderer* renderer, vtkVolume* volume) override
  {
    const vtkTypeBool autoAdjust = this->AutoAdjustSampleDistances;
    const vtkTypeBool lock = this->LockSampleDistanceToInputSpacing;
    const float distance = this->SampleDistance;
    if (auto* image = vtkImageData::SafeDownCast(this->GetInput()))
    {
      const double* spacing = image->GetSpacing();
      const double shortest = std::min({ spacing[0], spacing[1], spacing[2] });
      const bool given = !autoAdjust && !lock;
      this->SampleDistance =
        float(PartOfStep * (given ? std::min(shortest, double(distance)) : shortest));
      this->AutoAdjustSampleDistances = 0;
      this->LockSampleDistanceToInputSpacing = 0;
    }
    this->Superclass::GPURender(renderer, volume);
    this->AutoAdjustSampleDistances = autoAdjust;
    this->LockSampleDistanceToInputSpacing = lock;
    this->SampleDistance = distance;
  }
};

vtkStandardNewMacro(vtkRefinedMapper);

VTK_CREATE_CREATE_FUNCTION(vtkRefinedMapper);

class vtkRefinedMapperFactory : public vtkObjectFactory
{
public:
  static vtkRefinedMapperFactory* New();
  vtkTypeMacro(vtkRefinedMapperFactory, vtkObjectFactory);
  const char* GetVTKSourceVersion() override { return VTK_SOURCE_VERSION; }
  const char* GetDescription() override { return "VTK's mapper with a tenth of its steps"; }

protected:
  vtkRefinedMapperFactory()
  {
    this->RegisterOverride("vtkGPUVolumeRayCastMapper", "vtkRefinedMapper", "refined", 1,
      vtkObjectFactoryCreatevtkRefinedMapper);
  }
};

vtkStandardNewMacro(vtkRefinedMapperFactory);

}

void RegisterRefinedMapper()
{
  if (std::getenv("REFINED_VTK"))
  {
    // VTK's factory was registered first and would be asked first, so disable its override.
    vtkObjectFactory::SetAllEnableFlags(
      0, "vtkGPUVolumeRayCastMapper", "vtkOpenGLGPUVolumeRayCastMapper");
    vtkObjectFactory::RegisterFactory(vtkNew<vtkRefinedMapperFactory>());
  }
}
