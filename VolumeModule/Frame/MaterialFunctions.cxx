#include "Frame/MaterialFunctions.h"

#include "Core/Recipe/ShaderRecipe.h"
#include "Frame/PropertyTransferFunction.h"

#include "vtkColorTransferFunction.h"
#include "vtkImageData.h"
#include "vtkImplicitFunction.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

namespace varimarch
{

namespace
{

// Opacity curves; a null pointer stands for a curve that is 1 everywhere.
using Curves = std::vector<vtkPiecewiseFunction*>;

vtkMTimeType ChangeTime(vtkObject* object)
{
  return object ? object->GetMTime() : 0;
}

TransferFunction WithoutOpacities(const TransferFunction& function)
{
  return { function.Colors(), {}, function.OpacityUnitDistanceMm() };
}

// A function of two values stands in another table.
TransferFunction OfValues(const TransferFunction& first, const RenderSettings& settings)
{
  return settings.functionOf == FunctionOf::Value
    ? first
    : TransferFunction({}, {}, first.OpacityUnitDistanceMm());
}

std::vector<MaterialFunction> FunctionsOfMaterials(
  vtkVolumeProperty* property, const RenderSettings& settings, const TransferFunction& first)
{
  std::vector<MaterialFunction> functions;
  if (settings.mask == Mask::Labels)
  {
    functions.push_back({ 0, OfValues(first, settings), true });
    for (const int label : LabelsOf(property))
    {
      functions.push_back({ 0, LabelTransferFunctionOf(property, label, first), true });
    }
    return functions;
  }
  switch (settings.components)
  {
    case Components::LuminanceOpacity:
      return { { 0, WithoutOpacities(first), false }, { 1, first, true } };
    case Components::Rgba:
      return { { 3, first, true } };
    default:
      break;
  }
  functions.push_back({ 0, OfValues(first, settings), true });
  for (int component = 1; component < PartCount(settings); ++component)
  {
    functions.push_back({ component, FunctionOfComponent(property, component, first), true });
  }
  return functions;
}

// The curve of each material of a mixture, or of each row of labels.
Curves GradientOpacityCurvesOf(vtkVolumeProperty* property, const RenderSettings& settings)
{
  Curves curves;
  for (int part = 0; part < PartCount(settings); ++part)
  {
    const bool has =
      property->HasGradientOpacity(part) && !property->GetDisableGradientOpacity(part);
    curves.push_back(has ? property->GetGradientOpacity(part) : nullptr);
  }
  if (settings.mask == Mask::Labels)
  {
    for (const int label : LabelsOf(property))
    {
      vtkPiecewiseFunction* const own = property->GetLabelGradientOpacity(label);
      curves.push_back(own ? own : curves.front());
    }
  }
  return curves;
}

void TakeGradientOpacities(
  vtkVolumeProperty* property, const RenderSettings& settings, MaterialFunctions& functions)
{
  functions.gradientOpacityInputs = Fingerprint(property->GetMTime());
  for (vtkPiecewiseFunction* curve : GradientOpacityCurvesOf(property, settings))
  {
    functions.gradientOpacities.push_back(
      curve ? std::optional<TransferFunction>(OpacityCurveOf(curve)) : std::nullopt);
    functions.gradientOpacityInputs.Add(Fingerprint(curve, ChangeTime(curve)));
  }
}

// Everything that the functions of values are made from.
Fingerprint InputsOf(vtkVolumeProperty* property, const RenderSettings& settings)
{
  const bool hasLabels = settings.mask == Mask::Labels;
  const bool isOfValue = settings.functionOf == FunctionOf::Value;
  Fingerprint inputs(settings.components, settings.componentCount, settings.functionOf, hasLabels);
  for (int component = 0; component < PartCount(settings); ++component)
  {
    inputs.Add(TransferFunctionInputs(property, component));
  }
  if (!isOfValue || hasLabels)
  {
    inputs.Add(property->GetMTime());
  }
  if (hasLabels)
  {
    for (const int label : LabelsOf(property))
    {
      inputs.Add(Fingerprint(label, ChangeTime(property->GetLabelColor(label)),
        ChangeTime(property->GetLabelScalarOpacity(label))));
    }
  }
  if (!isOfValue)
  {
    inputs.Add(ChangeTime(property->GetTransferFunction2D()));
  }
  return inputs;
}

// The property reports changes of most of its functions, but not of these.
Fingerprint TimesOf(vtkVolumeProperty* property)
{
  Fingerprint times(ChangeTime(property), ChangeTime(property->GetSliceFunction()));
  for (const int label : LabelsOf(property))
  {
    times.Add(Fingerprint(label, ChangeTime(property->GetLabelColor(label)),
      ChangeTime(property->GetLabelScalarOpacity(label)),
      ChangeTime(property->GetLabelGradientOpacity(label))));
  }
  return times;
}

}

MaterialFunctions MaterialFunctionsOf(
  vtkVolumeProperty* property, const RenderSettings& settings, int surfaceComponent)
{
  MaterialFunctions functions;
  functions.inputs = InputsOf(property, settings);
  functions.tableInputs = Fingerprint(property, functions.inputs);
  functions.first = TransferFunctionOf(property);
  functions.ofMaterials = FunctionsOfMaterials(property, settings, functions.first);
  if (settings.blend == Blend::Isosurface)
  {
    functions.ofIsosurfaces = TransferFunctionOf(property, surfaceComponent);
  }
  functions.twoValues = property->GetTransferFunction2D();
  if (settings.gradientOpacity)
  {
    TakeGradientOpacities(property, settings, functions);
  }
  for (int part = 0; part < PartCount(settings); ++part)
  {
    functions.opacityUnitDistancesMm[part] =
      property->GetScalarOpacityUnitDistance(HasOpacities(property, part) ? part : 0);
  }
  functions.ofProperty = Fingerprint(property, TimesOf(property));
  return functions;
}

}
