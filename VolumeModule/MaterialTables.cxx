#include "MaterialTables.h"

#include "Core/ShaderRecipe.h"
#include "PropertyTransferFunction.h"

#include "vtkVolumeProperty.h"

namespace varimarch
{

std::vector<MaterialTable> MaterialTablesOf(
  vtkVolumeProperty* property, const RenderSettings& settings)
{
  switch (settings.components)
  {
    case Components::LuminanceOpacity:
      return { { 0, TransferFunctionOf(property), false },
        { 1, TransferFunctionOf(property), true } };
    case Components::Rgba:
      return { { 3, TransferFunctionOf(property), true } };
    default:
      break;
  }
  std::vector<MaterialTable> tables;
  for (int component = 0; component < PartCount(settings); ++component)
  {
    tables.push_back({ component, TransferFunctionOf(property, component), true });
  }
  return tables;
}

std::vector<double> MaterialTableInputs(vtkVolumeProperty* property, const RenderSettings& settings)
{
  std::vector<double> inputs = { double(settings.components), double(settings.componentCount) };
  for (int component = 0; component < PartCount(settings); ++component)
  {
    inputs.push_back(double(TransferFunctionTimeOf(property, component)));
    inputs.push_back(property->GetScalarOpacityUnitDistance(component));
  }
  return inputs;
}

}
