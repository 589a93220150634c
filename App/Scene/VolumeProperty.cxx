#include "Scene/VolumeProperty.h"

#include "Scene/ImageStatistics.h"

#include <vtkColorTransferFunction.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkVolumeProperty.h>

namespace varimarch
{

Look InUnitsOfData(const Look& look, vtkImageData* image)
{
  return look.domain == Domain::Data ? look : InUnitsOfData(look, ImageStatistics(image));
}

Look InUnitsOfData(const Look& look, const ImageStatistics& statistics)
{
  if (look.domain == Domain::Data)
  {
    return look;
  }
  const double zero = statistics.Percentile(1.0);
  const double one = statistics.Percentile(99.9);
  Look resolved = look;
  resolved.domain = Domain::Data;
  for (ColorNode& node : resolved.colors)
  {
    node.value = zero + node.value * (one - zero);
  }
  for (OpacityNode& node : resolved.opacities)
  {
    node.value = zero + node.value * (one - zero);
  }
  return resolved;
}

void ApplyLook(const Look& look, vtkVolumeProperty* property)
{
  // Without this a second node at a value would replace the first, and a step become a ramp.
  vtkNew<vtkColorTransferFunction> colors;
  colors->AllowDuplicateScalarsOn();
  for (const ColorNode& node : look.colors)
  {
    colors->AddRGBPoint(
      node.value, node.rgb.r, node.rgb.g, node.rgb.b, node.shape.midpoint, node.shape.sharpness);
  }
  vtkNew<vtkPiecewiseFunction> opacities;
  opacities->AllowDuplicateScalarsOn();
  for (const OpacityNode& node : look.opacities)
  {
    opacities->AddPoint(node.value, node.opacity, node.shape.midpoint, node.shape.sharpness);
  }
  property->SetColor(colors);
  property->SetScalarOpacity(opacities);
  property->SetScalarOpacityUnitDistance(look.opacityUnitDistanceMm);
  property->SetInterpolationTypeToLinear();
  property->SetShade(look.shading.enabled);
  property->SetAmbient(look.shading.ambient);
  property->SetDiffuse(look.shading.diffuse);
  property->SetSpecular(look.shading.specular);
  property->SetSpecularPower(look.shading.specularPower);
}

}
