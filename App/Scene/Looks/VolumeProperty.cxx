#include "Scene/Looks/VolumeProperty.h"

#include "Readers/ImageFacts.h"
#include "Scene/Volumes/ImageStatistics.h"

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

// The other values that stand for those of a look.
struct Values
{
  std::function<double(double)> valueOf;
  double factor; ///< mean change of a difference of values
};

Values ValuesFor(Domain domain, const ImageStatistics& statistics)
{
  if (domain == Domain::Relative)
  {
    const double zero = statistics.Percentile(1.0);
    const double range = statistics.Percentile(99.9) - zero;
    return { [=](double value) { return zero + value * range; }, range };
  }
  if (domain == Domain::Hounsfield && !MayBeHounsfieldUnits(statistics))
  {
    if (const auto scale = EstimatedHounsfieldScale(statistics))
    {
      return { [=](double value) { return scale->ValueAt(value); }, scale->Factor() };
    }
  }
  return { [](double value) { return value; }, 1.0 };
}

// The look with other values.
Look WithValues(const Look& look, const Values& values)
{
  Look resolved = OfData(look);
  const auto resolve = [&](double& value) { value = values.valueOf(value); };
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
  for (LookRegion& region : resolved.regions)
  {
    resolve(region.values[0]);
    resolve(region.values[1]);
  }
  return resolved;
}

void ScaleGradients(double factor, Look& look)
{
  for (OpacityNode& node : look.gradientOpacities)
  {
    node.value *= factor;
  }
  for (LookRegion& region : look.regions)
  {
    region.gradients[0] *= factor;
    region.gradients[1] *= factor;
  }
  look.dampingGradient *= factor;
}

Look InMillimetres(Look look, double lengthFactor)
{
  if (look.lengths == Lengths::Relative)
  {
    look.lengths = Lengths::Millimetres;
    look.opacityUnitDistanceMm *= lengthFactor;
    ScaleGradients(1.0 / lengthFactor, look);
  }
  return look;
}

// A look whose values are those of the first channel gets windows for the others, so that each
// channel looks as if it were alone.
std::vector<LookChannel> ChannelsFor(const Look& look, const ImageStatistics& statistics)
{
  std::vector<LookChannel> channels = WithAllChannels(look.channels, statistics.Channels());
  const std::size_t count = std::min(channels.size(), statistics.Channels().size());
  for (std::size_t i = 1; i < count && look.domain != Domain::Data; ++i)
  {
    const Values values = ValuesFor(look.domain, statistics.OfChannel(i));
    const std::array<double, 2> window = { values.valueOf(look.opacities.front().value),
      values.valueOf(look.opacities.back().value) };
    if (!channels[i].window && window[0] < window[1])
    {
      channels[i].window = window;
    }
  }
  return channels;
}

// The air beside a patient fills most of the first slice of nearly any CT. It spares counting all
// voxels, which may be in a file.
bool BeginsWithAir(vtkImageData* image)
{
  vtkDataArray* const values = image->GetPointData()->GetScalars();
  const int* const count = image->GetDimensions();
  const vtkIdType inSlice = std::min(vtkIdType(count[0]) * count[1], values->GetNumberOfTuples());
  for (vtkIdType i = 0; i < inSlice && values->GetNumberOfComponents() == 1; ++i)
  {
    if (values->GetComponent(i, 0) <= HighestAirHu)
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

void ApplyCurves(const Look& look, double meanSpacingMm, int component, vtkVolumeProperty* property)
{
  const bool surfaces = look.blend == Blend::Isosurface;
  property->SetColor(component, ColorsOf(surfaces ? ColorsOfSurfaces(look) : look.colors));
  property->SetScalarOpacity(
    component, CurveOf(surfaces ? OpacitiesOfSurfaces(look) : look.opacities, 1.0));
  property->SetGradientOpacity(component,
    look.gradientOpacities.empty() ? vtkSmartPointer<vtkPiecewiseFunction>()
                                   : CurveOf(look.gradientOpacities, meanSpacingMm));
  property->SetScalarOpacityUnitDistance(component, look.opacityUnitDistanceMm);
}

}

Look InUnitsOfData(const Look& look, vtkImageData* image)
{
  // The mapper refuses an image without values.
  if (!image->GetPointData()->GetScalars())
  {
    return OfData(look);
  }
  if (look.domain == Domain::Data && look.lengths == Lengths::Millimetres)
  {
    Look resolved = look;
    resolved.channels = WithAllChannels(look.channels, ChannelsIn(image));
    return resolved;
  }
  return look.domain == Domain::Hounsfield && BeginsWithAir(image)
    ? InMillimetres(OfData(look), LengthFactor(image, HighestAirHu))
    : InUnitsOfData(look, ImageStatistics(image));
}

Look InUnitsOfData(const Look& look, const ImageStatistics& statistics)
{
  const Values values = ValuesFor(look.domain, statistics);
  Look resolved = WithValues(look, values);
  ScaleGradients(values.factor, resolved);
  resolved.channels = ChannelsFor(look, statistics);
  return InMillimetres(resolved, statistics.LengthFactor());
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

void ApplyLook(const Look& look, vtkImageData* image, vtkVolumeProperty* property)
{
  const bool areColors = HoldsColors(image);
  const int count = std::clamp(image->GetNumberOfScalarComponents(), 1, int(MostChannels));
  property->SetIndependentComponents(!areColors);
  for (int component = 0; component < (areColors ? 1 : count); ++component)
  {
    ApplyCurves(
      LookOfChannel(look, std::size_t(component)), MeanSpacingMm(image), component, property);
  }
  ApplySurfaces(look.isosurfaces, property);
  ApplyShading(look.shading, property);
}

void ApplyShading(const Shading& shading, vtkVolumeProperty* property)
{
  for (int component = 0; component < int(MostChannels); ++component)
  {
    property->SetShade(component, shading.enabled);
    property->SetAmbient(component, shading.ambient);
    property->SetDiffuse(component, shading.diffuse);
    property->SetSpecular(component, shading.specular);
    property->SetSpecularPower(component, shading.specularPower);
  }
}

namespace
{

// Green and magenta, with what overlaps in white, are told apart with any kind of colour vision.
const std::array<glm::dvec3, MostChannels> UsualColors = { { { 0.2, 1.0, 0.2 }, { 1.0, 0.2, 1.0 },
  { 0.2, 0.8, 1.0 }, { 1.0, 0.8, 0.2 } } };

// Moves the values of all curves so that the opacities reach from end to end of a window.
void Stretch(const std::array<double, 2>& window, Look& look)
{
  const double first = look.opacities.front().value;
  const double width = look.opacities.back().value - first;
  if (!(width > 0.0))
  {
    return;
  }
  const double factor = (window[1] - window[0]) / width;
  const auto move = [&](auto& nodes)
  {
    for (auto& node : nodes)
    {
      node.value = window[0] + factor * (node.value - first);
    }
  };
  move(look.colors);
  move(look.opacities);
  move(look.isosurfaces);
  for (OpacityNode& node : look.gradientOpacities)
  {
    node.value *= factor;
  }
}

}

std::vector<LookChannel> WithAllChannels(
  std::vector<LookChannel> given, const std::vector<VolumeChannel>& channels)
{
  for (std::size_t i = 0; i < channels.size(); ++i)
  {
    if (i >= given.size())
    {
      given.push_back({ {}, channels[i].rgb.value_or(UsualColors[i % UsualColors.size()]) });
    }
    given[i].name = given[i].name.empty() ? channels[i].name : given[i].name;
  }
  return given;
}

Look LookOfChannel(const Look& look, std::size_t channel)
{
  Look own = look;
  if (channel >= look.channels.size())
  {
    return own;
  }
  const LookChannel& settings = look.channels[channel];
  if (settings.window)
  {
    Stretch(*settings.window, own);
  }
  if (settings.rgb)
  {
    own.colors = { { own.colors.front().value, *settings.rgb } };
  }
  for (OpacityNode& node : own.opacities)
  {
    node.opacity *= settings.visible ? settings.opacity : 0.0;
  }
  return own;
}

}
