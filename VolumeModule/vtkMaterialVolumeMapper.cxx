#include "vtkMaterialVolumeMapper.h"

#include "vtkImageData.h"
#include "vtkIndent.h"
#include "vtkInformationDoubleKey.h"
#include "vtkInformationIntegerKey.h"

vtkInformationKeyMacro(vtkMaterialVolumeMapper, LIGHT_SOFTNESS, Double);
vtkInformationKeyMacro(vtkMaterialVolumeMapper, CASTS_SHADOWS, Integer);

vtkMaterialVolumeMapper::vtkMaterialVolumeMapper() = default;

vtkMaterialVolumeMapper::~vtkMaterialVolumeMapper()
{
  this->SetTransfer2DYAxisArray(nullptr);
}

void vtkMaterialVolumeMapper::SetMaskInput(vtkImageData* mask)
{
  if (this->MaskInput != mask)
  {
    this->MaskInput = mask;
    this->Modified();
  }
}

vtkImageData* vtkMaterialVolumeMapper::GetMaskInput()
{
  return this->MaskInput;
}

void vtkMaterialVolumeMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NanColor: " << this->NanColor[0] << ", " << this->NanColor[1] << ", "
     << this->NanColor[2] << "\n";
  os << indent << "NanOpacity: " << this->NanOpacity << "\n";
  os << indent << "DampingGradient: " << this->DampingGradient << "\n";
  os << indent << "Shadows: " << (this->Shadows ? "On" : "Off") << "\n";
  os << indent << "ShadowStrength: " << this->ShadowStrength << "\n";
  os << indent << "VolumetricScatteringBlending: " << this->VolumetricScatteringBlending << "\n";
  os << indent << "GlobalIlluminationReach: " << this->GlobalIlluminationReach << "\n";
  os << indent << "ScatteringAnisotropy: " << this->ScatteringAnisotropy << "\n";
  os << indent << "AmbientOcclusion: " << this->AmbientOcclusion << "\n";
  os << indent << "AmbientOcclusionReach: " << this->AmbientOcclusionReach << "\n";
  os << indent << "MaskInput: " << this->MaskInput << "\n";
  os << indent << "MaskType: " << this->MaskType << "\n";
  os << indent << "MaskBlendFactor: " << this->MaskBlendFactor << "\n";
  os << indent << "LabelSurfaces: " << this->LabelSurfaces << "\n";
  os << indent << "Transfer2DYAxisArray: "
     << (this->Transfer2DYAxisArray ? this->Transfer2DYAxisArray : "none") << "\n";
}
