#include "vtkVariationFieldVolumeMapper.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkStringArray.h"

struct vtkVariationFieldVolumeMapper::GraphicsResources
{
};

vtkStandardNewMacro(vtkVariationFieldVolumeMapper);
vtkVariationFieldVolumeMapper::vtkVariationFieldVolumeMapper() = default;
vtkVariationFieldVolumeMapper::~vtkVariationFieldVolumeMapper() = default;
void vtkVariationFieldVolumeMapper::Render(vtkRenderer*, vtkVolume*) {}
void vtkVariationFieldVolumeMapper::ReleaseGraphicsResources(vtkWindow*) {}
vtkIdType vtkVariationFieldVolumeMapper::GetGraphicsMemoryBytes() { return 0; }
void vtkVariationFieldVolumeMapper::GetShaderParts(vtkStringArray*) {}
void vtkVariationFieldVolumeMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
int vtkVariationFieldVolumeMapper::FillInputPortInformation(int port, vtkInformation* information)
{
  return this->Superclass::FillInputPortInformation(port, information);
}
