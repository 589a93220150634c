#include "Frame/MaterialChoices.h"

#include "Core/Recipe/ShaderRecipe.h"
#include "Frame/PropertyTransferFunction.h"
#include "VtkVersions.h"
#include "vtkVariationFieldVolumeMapper.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace varimarch
{

namespace
{

// The kind of an array's components. Throws std::runtime_error if they cannot be drawn.
Components ComponentsOf(const std::string& name, int count, bool independent)
{
  if (count < 1 || count > 4)
  {
    throw std::runtime_error(
      "Array \"" + name + "\" has " + std::to_string(count) + " components: expected 1 to 4");
  }
  if (count == 1)
  {
    return Components::One;
  }
  if (!independent && count == 3)
  {
    throw std::runtime_error("Array \"" + name +
      "\" has 3 components that depend on each other: expected 2 (colour and opacity), 4 (red, "
      "green, blue and opacity), or independent ones");
  }
  return independent ? Components::Independent
    : count == 2     ? Components::LuminanceOpacity
                     : Components::Rgba;
}

// Only composites of one component have transfer functions of two values.
FunctionOf FunctionOfMapper(vtkVariationFieldVolumeMapper* mapper, vtkVolumeProperty* property,
  const RenderSettings& settings)
{
  if (property->GetTransferFunctionMode() != vtkVolumeProperty::TF_2D ||
    settings.blend != Blend::Composite || settings.components != Components::One)
  {
    return FunctionOf::Value;
  }
  const char* const second = mapper->GetTransfer2DYAxisArray();
  return second && *second ? FunctionOf::TwoValues : FunctionOf::ValueAndGradient;
}

Mask MaskOf(vtkVariationFieldVolumeMapper* mapper, const RenderSettings& settings)
{
  if (!mapper->GetMaskInput())
  {
    return Mask::None;
  }
  if (mapper->GetMaskType() == vtkVariationFieldVolumeMapper::BinaryMaskType)
  {
    return Mask::Binary;
  }
  const bool hasLabels = settings.blend == Blend::Composite &&
    settings.components == Components::One && settings.functionOf != FunctionOf::TwoValues;
  return hasLabels ? Mask::Labels : Mask::None;
}

MaskVoxels MaskVoxelsOf(vtkVariationFieldVolumeMapper* mapper, vtkVolumeProperty* property)
{
  vtkImageData* const image = mapper->GetMaskInput();
  vtkDataArray* const labels = image->GetPointData()->GetScalars();
  if (!labels || labels->GetNumberOfComponents() != 1 || labels->GetNumberOfTuples() == 0)
  {
    throw std::runtime_error("The mask has no scalars of one component");
  }
  MaskVoxels mask;
  mask.labels = labels;
  int* const dimensions = image->GetDimensions();
  mask.dimensions = { dimensions[0], dimensions[1], dimensions[2] };
  mask.time = std::max(image->GetMTime(), labels->GetMTime());
  mask.binary = mapper->GetMaskType() == vtkVariationFieldVolumeMapper::BinaryMaskType;
  mask.rows = mask.binary ? std::vector<int>() : LabelsOf(property);
  return mask;
}

// The component that has the second value of a transfer function of two values.
VoxelComponent SecondComponent(vtkVariationFieldVolumeMapper* mapper, vtkDataSet* data)
{
  const std::string name = mapper->GetTransfer2DYAxisArray();
  vtkDataArray* const second = data->GetPointData()->GetArray(name.c_str());
  if (!second || second->GetNumberOfComponents() != 1)
  {
    throw std::runtime_error("The second value of the transfer function, array \"" + name +
      "\", is missing: expected point data with one component");
  }
  return { second, 0 };
}

bool HasGradientOpacity(vtkVolumeProperty* property, const RenderSettings& settings)
{
  if (settings.mask == Mask::Labels && property->HasLabelGradientOpacity())
  {
    return true;
  }
  if (settings.functionOf != FunctionOf::Value)
  {
    return false; // VTK ignores gradient opacity here too
  }
  for (int part = 0; part < PartCount(settings); ++part)
  {
    if (property->HasGradientOpacity(part) && !property->GetDisableGradientOpacity(part))
    {
      return settings.blend == Blend::Composite;
    }
  }
  return false;
}

// VTK's blending depends on its steps. In the limit of short ones it is this part.
void ChooseScattering(vtkVariationFieldVolumeMapper* mapper, Frame& frame)
{
  constexpr double MostAnisotropy = 0.99; // its phase function still has a density
  MaterialRequest& material = frame.material;
  material.surfacesInShadow = mapper->GetShadows() ? mapper->GetShadowStrength() : 0.0;
  material.shadowReachMm = ShadowReachMm(
    material.surfacesInShadow > 0.0 ? 1.0 : mapper->GetGlobalIlluminationReach(), frame.geometry);
  if (frame.settings.scattering)
  {
    material.scatteredPart = std::min(mapper->GetVolumetricScatteringBlending(), 1.0);
    const double own = mapper->GetScatteringAnisotropy();
    material.anisotropy = std::clamp(own != 0.0 ? own : ScatteringAnisotropyOf(material.property),
      -MostAnisotropy, MostAnisotropy);
  }
}

}

void ChooseMaterial(vtkVariationFieldVolumeMapper* mapper, vtkVolumeProperty* property,
  vtkDataArray* scalars, RenderSettings& settings)
{
  settings.componentCount = scalars->GetNumberOfComponents();
  settings.components = ComponentsOf(scalars->GetName() ? scalars->GetName() : "scalars",
    settings.componentCount, property->GetIndependentComponents() != 0);
  settings.functionOf = FunctionOfMapper(mapper, property, settings);
  settings.mask = MaskOf(mapper, settings);
  const bool hasLight = property->GetShade() != 0 || mapper->GetAmbientOcclusion() > 0.0;
  settings.labelSurfaces =
    settings.mask == Mask::Labels && hasLight && mapper->GetLabelSurfaces() != 0;
  settings.gradientOpacity = HasGradientOpacity(property, settings);
  settings.storedGradients =
    mapper->GetStoredGradients() != 0 && settings.components == Components::One;
}

void ChooseVoxels(vtkVariationFieldVolumeMapper* mapper, vtkDataSet* data, Frame& frame)
{
  for (int component = 0; component < frame.settings.componentCount; ++component)
  {
    frame.voxels.components.push_back({ frame.voxels.scalars, component });
  }
  if (frame.settings.functionOf == FunctionOf::TwoValues)
  {
    frame.voxels.components.push_back(SecondComponent(mapper, data));
    if (frame.voxels.components.back().array->GetNumberOfTuples() !=
      frame.voxels.scalars->GetNumberOfTuples())
    {
      throw std::runtime_error("The arrays of the transfer function's two values differ in length");
    }
    frame.voxels.time =
      std::max(frame.voxels.time, frame.voxels.components.back().array->GetMTime());
  }
  if (frame.settings.mask != Mask::None)
  {
    frame.voxels.mask = MaskVoxelsOf(mapper, frame.material.property);
  }
  frame.material.labelBlend = mapper->GetMaskBlendFactor();
}

void ChooseLight(vtkVariationFieldVolumeMapper* mapper, Frame& frame)
{
  frame.material.dampingGradient = mapper->GetDampingGradient();
  ChooseScattering(mapper, frame);
  frame.material.occlusion = mapper->GetAmbientOcclusion();
  frame.material.occlusionReachMm =
    OcclusionReachMm(mapper->GetAmbientOcclusionReach(), frame.geometry);
  frame.material.occluderVoxelMm = frame.geometry.SmallestSpacingMm();
  frame.material.occludersMm = frame.geometry.DiagonalMm();
}

void ChooseSurfaceComponent(Frame& frame)
{
  if (frame.settings.components == Components::One)
  {
    return;
  }
  if (frame.settings.components != Components::Independent)
  {
    throw std::runtime_error(
      "Isosurfaces of components that depend on each other are not supported");
  }
  for (int component = 1; component < frame.settings.componentCount; ++component)
  {
    if (frame.material.property->GetComponentWeight(component) >
      frame.material.property->GetComponentWeight(frame.material.surfaceComponent))
    {
      frame.material.surfaceComponent = component;
    }
  }
  frame.voxels.components = { frame.voxels.components[frame.material.surfaceComponent] };
  frame.settings.components = Components::One;
  frame.settings.componentCount = 1;
}

}
