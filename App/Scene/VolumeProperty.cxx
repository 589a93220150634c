#include "Scene/VolumeProperty.h"

#include "Scene/HounsfieldScale.h"
#include "Scene/ImageStatistics.h"

#include <vtkColorTransferFunction.h>
#include <vtkContourValues.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace varimarch
{

namespace
{

// Both functions allow duplicates. Otherwise a second node at the same value would replace the
// first, and a step would become a ramp.
vtkSmartPointer<vtkColorTransferFunction> ColorsOf(const std::vector<ColorNode>& nodes)
{
  auto colors = vtkSmartPointer<vtkColorTransferFunction>::New();
  colors->AllowDuplicateScalarsOn();
  for (const ColorNode& node : nodes)
  {
    colors->AddRGBPoint(
      node.value, node.rgb.r, node.rgb.g, node.rgb.b, node.shape.midpoint, node.shape.sharpness);
  }
  return colors;
}

vtkSmartPointer<vtkPiecewiseFunction> CurveOf(
  const std::vector<OpacityNode>& nodes, double factorOfValues)
{
  auto curve = vtkSmartPointer<vtkPiecewiseFunction>::New();
  curve->AllowDuplicateScalarsOn();
  for (const OpacityNode& node : nodes)
  {
    curve->AddPoint(
      factorOfValues * node.value, node.opacity, node.shape.midpoint, node.shape.sharpness);
  }
  return curve;
}

// VTK takes the colour and opacity of isosurfaces from the transfer functions.
std::vector<ColorNode> ColorsOfSurfaces(const Look& look)
{
  std::vector<ColorNode> nodes;
  for (const Isosurface& surface : look.isosurfaces)
  {
    nodes.push_back({ surface.value, surface.rgb });
  }
  return nodes;
}

std::vector<OpacityNode> OpacitiesOfSurfaces(const Look& look)
{
  std::vector<OpacityNode> nodes;
  for (const Isosurface& surface : look.isosurfaces)
  {
    nodes.push_back({ surface.value, surface.opacity });
  }
  return nodes;
}

Look OfData(Look look)
{
  look.domain = Domain::Data;
  return look;
}

// The look with other values.
// @param factor  mean change of a difference of values
Look Resolved(const Look& look, const std::function<double(double)>& valueOf, double factor)
{
  Look resolved = OfData(look);
  const auto resolve = [&](double& value) { value = valueOf(value); };
  for (ColorNode& node : resolved.colors)
  {
    resolve(node.value);
  }
  for (OpacityNode& node : resolved.opacities)
  {
    resolve(node.value);
  }
  for (Isosurface& surface : resolved.isosurfaces)
  {
    resolve(surface.value);
  }
  if (resolved.averagedRange)
  {
    resolve((*resolved.averagedRange)[0]);
    resolve((*resolved.averagedRange)[1]);
  }
  for (OpacityNode& node : resolved.gradientOpacities)
  {
    node.value *= factor;
  }
  for (LookRegion& region : resolved.regions)
  {
    resolve(region.values[0]);
    resolve(region.values[1]);
    region.gradients[0] *= factor;
    region.gradients[1] *= factor;
  }
  resolved.dampingGradient *= factor;
  return resolved;
}

// The air beside a patient makes the first slice of nearly any CT negative. It spares counting all
// voxels, which may be in a file.
bool BeginsWithNegativeValues(vtkImageData* image)
{
  vtkDataArray* const values = image->GetPointData()->GetScalars();
  const int* const count = image->GetDimensions();
  const vtkIdType inSlice = std::min(vtkIdType(count[0]) * count[1], values->GetNumberOfTuples());
  for (vtkIdType i = 0; i < inSlice; ++i)
  {
    if (values->GetComponent(i, 0) < 0.0)
    {
      return true;
    }
  }
  return false;
}

void ApplySurfaces(const std::vector<Isosurface>& surfaces, vtkVolumeProperty* property)
{
  property->GetIsoSurfaceValues()->SetNumberOfContours(int(surfaces.size()));
  for (int i = 0; i < int(surfaces.size()); ++i)
  {
    property->GetIsoSurfaceValues()->SetValue(i, surfaces[i].value);
  }
}

}

Look InUnitsOfData(const Look& look, vtkImageData* image)
{
  // The mapper refuses an image without values.
  const bool isResolved = look.domain == Domain::Data || !image->GetPointData()->GetScalars() ||
    (look.domain == Domain::Hounsfield && BeginsWithNegativeValues(image));
  return isResolved ? OfData(look) : InUnitsOfData(look, ImageStatistics(image));
}

Look InUnitsOfData(const Look& look, const ImageStatistics& statistics)
{
  if (look.domain == Domain::Relative)
  {
    const double zero = statistics.Percentile(1.0);
    const double range = statistics.Percentile(99.9) - zero;
    return Resolved(
      look, [=](double value) { return zero + value * range; }, range);
  }
  if (look.domain == Domain::Hounsfield && !MayBeHounsfieldUnits(statistics))
  {
    if (const auto scale = EstimatedHounsfieldScale(statistics))
    {
      return Resolved(
        look, [&](double value) { return scale->ValueAt(value); }, scale->Factor());
    }
  }
  return OfData(look);
}

bool Suits(const Look& look, const ImageStatistics& statistics)
{
  return look.domain != Domain::Hounsfield || MayBeHounsfieldUnits(statistics) ||
    EstimatedHounsfieldScale(statistics);
}

double MeanSpacingMm(vtkImageData* image)
{
  const double* const spacing = image->GetSpacing();
  return (std::abs(spacing[0]) + std::abs(spacing[1]) + std::abs(spacing[2])) / 3.0;
}

void ApplyLook(const Look& look, double meanSpacingMm, vtkVolumeProperty* property)
{
  const bool surfaces = look.blend == Blend::Isosurface;
  property->SetColor(ColorsOf(surfaces ? ColorsOfSurfaces(look) : look.colors));
  property->SetScalarOpacity(CurveOf(surfaces ? OpacitiesOfSurfaces(look) : look.opacities, 1.0));
  ApplySurfaces(look.isosurfaces, property);
  property->SetGradientOpacity(look.gradientOpacities.empty()
      ? vtkSmartPointer<vtkPiecewiseFunction>()
      : CurveOf(look.gradientOpacities, meanSpacingMm));
  property->SetScalarOpacityUnitDistance(look.opacityUnitDistanceMm);
  ApplyShading(look.shading, property);
}

void ApplyShading(const Shading& shading, vtkVolumeProperty* property)
{
  property->SetShade(shading.enabled);
  property->SetAmbient(shading.ambient);
  property->SetDiffuse(shading.diffuse);
  property->SetSpecular(shading.specular);
  property->SetSpecularPower(shading.specularPower);
}

}
