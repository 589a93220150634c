#include "Frame/MaterialChoices.h"

#include "Core/Recipe/ShaderRecipe.h"
#include "Frame/MapperNumbers.h"
#include "Frame/NumberCheck.h"
#include "Frame/PropertyTransferFunction.h"
#include "VtkVersions.h"
#include "vtkVariationFieldVolumeMapper.h"

#include "vtkContourValues.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkImageData.h"
#include "vtkImplicitFunction.h"
#include "vtkPointData.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>
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
  if (labels->GetNumberOfTuples() != image->GetNumberOfPoints())
  {
    throw std::runtime_error("The mask has " + std::to_string(labels->GetNumberOfTuples()) +
      " values: expected one for each of its " + std::to_string(image->GetNumberOfPoints()) +
      " voxels");
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
void ChooseScattering(
  vtkVariationFieldVolumeMapper* mapper, const MapperNumbers& numbers, Frame& frame)
{
  constexpr double MostAnisotropy = 0.99; // its phase function still has a density
  MaterialRequest& material = frame.material;
  material.surfacesInShadow = mapper->GetShadows() ? numbers.shadowStrength : 0.0;
  material.shadowReachMm = ShadowReachMm(
    material.surfacesInShadow > 0.0 ? 1.0 : numbers.illuminationReach, frame.geometry);
  if (frame.settings.scattering)
  {
    material.scatteredPart = std::min(numbers.scatteringBlending, 1.0);
    const double own = numbers.scatteringAnisotropy;
    material.anisotropy =
      std::clamp(own != 0.0 ? own : material.anisotropy, -MostAnisotropy, MostAnisotropy);
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

void ChooseVoxels(vtkVariationFieldVolumeMapper* mapper, vtkVolumeProperty* property,
  vtkDataSet* data, Frame& frame)
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
    frame.voxels.mask = MaskVoxelsOf(mapper, property);
  }
}

void TakeProperty(vtkVolumeProperty* property, NumberCheck& check, MaterialRequest& material)
{
  constexpr double Most = 1e6; // products of these and of lights are floats
  // A power of 0 would have no value where no light is mirrored.
  constexpr double LeastPower = 1e-6;
  const auto usable = [&](const char* setter, double usual, double found) {
    return check.Usable({ setter, -Most, Most, usual }, found);
  };
  for (int i = 0; i < int(material.reflectances.size()); ++i)
  {
    const double power = check.Usable(
      { "vtkVolumeProperty::SetSpecularPower", 0.0, Most, 10.0 }, property->GetSpecularPower(i));
    material.reflectances[i] = { usable(
                                   "vtkVolumeProperty::SetAmbient", 0.1, property->GetAmbient(i)),
      usable("vtkVolumeProperty::SetDiffuse", 0.7, property->GetDiffuse(i)),
      usable("vtkVolumeProperty::SetSpecular", 0.2, property->GetSpecular(i)),
      std::max(power, LeastPower) };
    material.weights[i] = check.Usable(
      { "vtkVolumeProperty::SetComponentWeight", 0.0, 1.0, 1.0 }, property->GetComponentWeight(i));
  }
  constexpr double Largest = std::numeric_limits<double>::max();
  material.clippedScalar =
    check.Usable({ "vtkVolumeProperty::SetClippedVoxelIntensity", -Largest, Largest, -Largest },
      property->GetClippedVoxelIntensity());
  material.anisotropy = check.Usable(
    { "vtkVolumeProperty::SetScatteringAnisotropy", -1.0, 1.0 }, ScatteringAnisotropyOf(property));
}

void ChooseLight(vtkVariationFieldVolumeMapper* mapper, const MapperNumbers& numbers, Frame& frame)
{
  frame.material.labelBlend = numbers.maskBlendFactor;
  frame.material.dampingGradient = numbers.dampingGradient;
  ChooseScattering(mapper, numbers, frame);
  frame.material.occlusion = numbers.occlusion;
  frame.material.occlusionReachMm = OcclusionReachMm(numbers.occlusionReachMm, frame.geometry);
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
    if (frame.material.weights[component] > frame.material.weights[frame.material.surfaceComponent])
    {
      frame.material.surfaceComponent = component;
    }
  }
  frame.voxels.components = { frame.voxels.components[frame.material.surfaceComponent] };
  frame.settings.components = Components::One;
  frame.settings.componentCount = 1;
}

namespace
{

// The finite isovalues, ascending and without duplicates.
std::vector<double> IsovaluesOf(vtkVolumeProperty* property)
{
  vtkContourValues* const contours = property->GetIsoSurfaceValues();
  const double* const values = contours->GetValues();
  std::set<double> isovalues;
  const int count = contours->GetNumberOfContours();
  std::copy_if(values, values + count, std::inserter(isovalues, isovalues.end()),
    [](double value) { return std::isfinite(value); });
  if (count > 0 && isovalues.empty())
  {
    throw std::invalid_argument("Cannot draw the isovalue " + TextOf(values[0]) +
      ": expected a finite number in vtkVolumeProperty::GetIsoSurfaceValues");
  }
  return { isovalues.begin(), isovalues.end() };
}

}

bool ChooseSurfaces(vtkVolumeProperty* property, Frame& frame)
{
  if (frame.settings.blend == Blend::Isosurface)
  {
    ChooseSurfaceComponent(frame);
    if (frame.settings.cubic)
    {
      throw std::runtime_error("Isosurfaces of cubic interpolation are not supported");
    }
    frame.material.isovalues = IsovaluesOf(property);
    return !frame.material.isovalues.empty();
  }
  if (frame.settings.blend == Blend::Slice)
  {
    vtkImplicitFunction* const function = property->GetSliceFunction();
    frame.material.slice = function ? SliceSurfaceOf(function, frame.geometry) : SliceSurface();
    // A slice in a face of the volume counts as inside despite rounding.
    constexpr double ReachVoxels = 3e-4;
    frame.geometry.boxGrid.lower -= ReachVoxels;
    frame.geometry.boxGrid.upper += ReachVoxels;
    return function != nullptr;
  }
  return true;
}

}
