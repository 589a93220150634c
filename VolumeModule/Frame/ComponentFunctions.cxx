#include "Frame/ComponentFunctions.h"

#include "Frame/PropertyTransferFunction.h"

#include <vtkPiecewiseFunction.h>
#include <vtkVolumeProperty.h>

namespace varimarch
{

namespace
{

// True for the straight function from 0 to 1024 that VTK makes for a component without one.
bool IsDefault(vtkPiecewiseFunction* function, double first)
{
  double left[4];
  double right[4];
  return function->GetSize() == 2 && function->GetNodeValue(0, left) == 1 &&
    function->GetNodeValue(1, right) == 1 && left[0] == 0.0 && left[1] == first &&
    right[0] == 1024.0 && right[1] == 1.0;
}

bool HasColors(vtkVolumeProperty* property, int component)
{
  return property->GetColorChannels(component) != 1 ||
    !IsDefault(property->GetGrayTransferFunction(component), 0.0);
}

}

bool HasOpacities(vtkVolumeProperty* property, int component)
{
  return !IsDefault(property->GetScalarOpacity(component), 1.0);
}

TransferFunction FunctionOfComponent(vtkVolumeProperty* property, int component)
{
  const TransferFunction own = TransferFunctionOf(property, component);
  if (component == 0)
  {
    return own;
  }
  const TransferFunction first = TransferFunctionOf(property);
  const TransferFunction& opacities = HasOpacities(property, component) ? own : first;
  return { HasColors(property, component) ? own.Colors() : first.Colors(), opacities.Opacities(),
    opacities.OpacityUnitDistanceMm() };
}

}
