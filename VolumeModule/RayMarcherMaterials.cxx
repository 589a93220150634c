// The resources and uniforms of materials: what gives a point of the volume its look beyond one
// transfer function.

#include "Core/ShaderRecipe.h"
#include "Lights.h"
#include "PropertyTransferFunction.h"
#include "RayMarcher.h"

#include "vtkDataArray.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPiecewiseFunction.h"
#include "vtkRenderer.h"
#include "vtkVolumeProperty.h"

#include <glm/matrix.hpp>

#include <algorithm>

namespace varimarch
{

namespace
{

// So many that a piecewise linear function loses less than a display can show.
constexpr int GradientOpacityEntryCount = 4096;

using Curves = std::vector<vtkPiecewiseFunction*>; ///< none: 1 everywhere

// Of each part, or of each row of labels.
Curves GradientOpacitiesOf(vtkVolumeProperty* property, const RenderSettings& settings)
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

// Four curves share the numbers of an entry.
/// @param largest  of each curve, the gradient of the last entry; one for all curves of labels
std::vector<glm::vec4> GradientOpacityEntries(
  const Curves& curves, const std::vector<double>& largest)
{
  const std::size_t groups = (curves.size() + 3) / 4;
  std::vector<glm::vec4> entries(groups * GradientOpacityEntryCount, glm::vec4(1.0f));
  for (std::size_t i = 0; i < curves.size(); ++i)
  {
    if (curves[i])
    {
      const TransferFunction curve = OpacityCurveOf(curves[i]);
      const double last = largest[std::min(i, largest.size() - 1)];
      for (int entry = 0; entry < GradientOpacityEntryCount; ++entry)
      {
        const double gradient = last * entry / (GradientOpacityEntryCount - 1);
        entries[i / 4 * GradientOpacityEntryCount + entry][int(i % 4)] =
          float(curve.Opacity(gradient));
      }
    }
  }
  return entries;
}

// What a texel of a colour must be multiplied by, as VTK takes numbers that are colours.
double LargestColor(vtkDataArray* array)
{
  switch (array->GetDataType())
  {
    case VTK_FLOAT:
    case VTK_DOUBLE:
      return 1.0;
    case VTK_SHORT:
    case VTK_UNSIGNED_SHORT:
      return array->GetDataTypeMax();
    default:
      return 255.0;
  }
}

// The component that a part's opacity is of.
int OpacityComponentOf(const RenderSettings& settings, int part)
{
  switch (settings.components)
  {
    case Components::LuminanceOpacity:
      return 1;
    case Components::Rgba:
      return 3;
    default:
      return part;
  }
}

// Of each part.
glm::dvec4 UnitDistancesOf(const Frame& frame)
{
  glm::dvec4 distances(1.0);
  for (int part = 0; part < PartCount(frame.settings); ++part)
  {
    distances[part] = frame.property->GetScalarOpacityUnitDistance(part);
  }
  return distances;
}

std::array<double, 4> WeightsOf(const Frame& frame)
{
  std::array<double, 4> weights = { 1.0, 1.0, 1.0, 1.0 };
  for (int part = 0; part < PartCount(frame.settings); ++part)
  {
    weights[part] = frame.settings.components == Components::Independent
      ? frame.property->GetComponentWeight(part)
      : 1.0;
  }
  return weights;
}

}

glm::dvec4 ReflectanceOf(vtkVolumeProperty* property, int component)
{
  return { property->GetAmbient(component), property->GetDiffuse(component),
    property->GetSpecular(component), property->GetSpecularPower(component) };
}

void RayMarcher::UpdateLights(const Frame& frame)
{
  if (frame.settings.lights && frame.marcher == Marcher::Device)
  {
    this->lights.Upload(frame.window, LightTexelsOf(frame.renderer).texels);
  }
  else
  {
    this->lights.Release(frame.window);
  }
}

void RayMarcher::UpdateGradientOpacity(const Frame& frame)
{
  if (!frame.settings.gradientOpacity)
  {
    this->gradientOpacity.Release(frame.window);
    this->gradientOpacitySource.clear();
    return;
  }
  std::vector<double> largest;
  const Curves curves = GradientOpacitiesOf(frame.property, frame.settings);
  std::vector<double> source = { double(frame.property->GetMTime()) };
  for (vtkPiecewiseFunction* curve : curves)
  {
    source.push_back(curve ? double(curve->GetMTime()) : 0.0);
  }
  for (int part = 0; part < PartCount(frame.settings); ++part)
  {
    const int component = OpacityComponentOf(frame.settings, part);
    largest.push_back(LargestGradient(this->blocks.TexelsOfChannels()[component]));
  }
  source.insert(source.end(), largest.begin(), largest.end());
  if (this->gradientOpacitySource != source)
  {
    this->gradientOpacity.Set(frame.window, GradientOpacityEntries(curves, largest));
    this->gradientOpacitySource = source;
  }
  this->gradientOpacity.Update(frame.window, frame.marcher);
}

void RayMarcher::SetMaterialUniforms(const Frame& frame, const DrawnBlock& drawn)
{
  this->program.Set("voxelSizeTexture", 1.0 / glm::dvec3(drawn.voxels.count));
  if (frame.settings.components != Components::One)
  {
    this->SetComponentUniforms(frame);
  }
  else
  {
    std::array<double, 2> visible = this->opticalTable.VisibleValues();
    for (std::size_t i = 1; i < this->opticalTable.Tables().size(); ++i)
    {
      const std::array<double, 2>& values = this->opticalTable.VisibleValues(i);
      visible = { std::min(visible[0], values[0]), std::max(visible[1], values[1]) };
    }
    const TexelMapping& mapping = this->blocks.Texels().mapping;
    this->program.Set("visibleScalars",
      glm::dvec2(mapping.LimitedTexelOf(visible[0]), mapping.LimitedTexelOf(visible[1])));
    this->program.Set("reflectance", ReflectanceOf(frame.property, 0));
  }
  if (frame.settings.shading)
  {
    this->SetLightUniforms(frame);
  }
  if (frame.settings.gradientOpacity)
  {
    this->SetGradientOpacityUniforms(frame);
  }
}

void RayMarcher::SetComponentTableUniforms()
{
  std::array<glm::dvec2, 4> fromScalar = {};
  std::array<double, 4> first = {};
  std::array<double, 4> last = {};
  for (std::size_t i = 0; i < this->materialTables.size(); ++i)
  {
    const OpticalTable& table = this->opticalTable.Tables()[i];
    const int channel = this->materialTables[i].channel;
    const TexelMapping& mapping = this->blocks.TexelsOfChannels()[channel].mapping;
    const double extent = table.lastValue - table.firstValue;
    last[i] = double(table.entries.size() - 1);
    first[i] = double(this->opticalTable.FirstEntryOf(i));
    const double indexPerValue = extent > 0.0 ? last[i] / extent : 0.0;
    fromScalar[i] = { mapping.scale * indexPerValue,
      (mapping.offset - table.firstValue) * indexPerValue };
  }
  this->opticalTable.Texture()->Activate();
  this->program.Set("opticalTable", this->opticalTable.Texture());
  this->program.Set("tablesFromScalar", fromScalar);
  this->program.Set("firstEntries", first);
  this->program.Set("lastTableIndices", last);
  const std::vector<ScalarTexels>& texels = this->blocks.TexelsOfChannels();
  if (this->materialTables.front().channel == 3)
  {
    const double largest = LargestColor(this->volumeSource.front().array);
    const TexelMapping mappings[] = { texels[0].mapping, texels[1].mapping, texels[2].mapping };
    this->program.Set(
      "colorScale", glm::dvec3(mappings[0].scale, mappings[1].scale, mappings[2].scale) / largest);
    this->program.Set("colorBias",
      glm::dvec3(mappings[0].offset, mappings[1].offset, mappings[2].offset) / largest);
  }
}

void RayMarcher::SetComponentUniforms(const Frame& frame)
{
  std::array<glm::dvec2, 4> visibleScalars;
  visibleScalars.fill({ 1e30, -1e30 }); // none
  for (std::size_t i = 0; i < this->materialTables.size(); ++i)
  {
    const MaterialTable& table = this->materialTables[i];
    if (table.decidesOnOpacity)
    {
      const TexelMapping& mapping = this->blocks.TexelsOfChannels()[table.channel].mapping;
      const std::array<double, 2>& visible = this->opticalTable.VisibleValues(i);
      visibleScalars[table.channel] = { mapping.LimitedTexelOf(visible[0]),
        mapping.LimitedTexelOf(visible[1]) };
    }
  }
  std::array<glm::dvec4, 4> reflectances = {};
  for (int part = 0; part < PartCount(frame.settings); ++part)
  {
    reflectances[part] = ReflectanceOf(frame.property, part);
  }
  this->program.Set("visibleScalarsOf", visibleScalars);
  this->program.Set("reflectances", reflectances);
  this->program.Set("partWeights", WeightsOf(frame));
}

void RayMarcher::SetComponentProjectionUniforms(const Frame& frame)
{
  const std::vector<ScalarTexels>& channels = this->blocks.TexelsOfChannels();
  glm::dvec4 smallest(0.0);
  glm::dvec4 leastMaximum(0.0);
  glm::dvec4 mostMinimum(0.0);
  glm::dvec4 grayPerScalar(0.0);
  glm::dvec4 averagedLower(0.0);
  glm::dvec4 averagedUpper(0.0);
  for (int i = 0; i < int(channels.size()); ++i)
  {
    const TexelMapping& mapping = channels[i].mapping;
    smallest[i] = mapping.TexelOf(channels[i].smallestScalar);
    const double range = mapping.TexelOf(channels[i].largestScalar) - smallest[i];
    grayPerScalar[i] = range > 0.0 ? 1.0 / range : 0.0;
    leastMaximum[i] = mapping.TexelOf(channels[i].smallestValue);
    mostMinimum[i] = mapping.TexelOf(channels[i].largestValue);
    averagedLower[i] = mapping.LimitedTexelOf(frame.averagedRange[0]);
    averagedUpper[i] = mapping.LimitedTexelOf(frame.averagedRange[1]);
  }
  this->program.Set("partWeights", WeightsOf(frame));
  this->program.Set("opacityUnitDistancesMm", UnitDistancesOf(frame));
  if (IsExtreme(frame.settings.blend))
  {
    const bool isMaximum = frame.settings.blend == Blend::MaximumIntensity;
    this->program.Set("sense", isMaximum ? 1.0 : -1.0);
    this->program.Set("leastExtremes", isMaximum ? leastMaximum : mostMinimum);
    return;
  }
  this->program.Set("smallestScalars", smallest);
  this->program.Set("grayPerScalars", grayPerScalar);
  if (frame.settings.blend == Blend::AverageIntensity)
  {
    this->program.Set("averagedLower", averagedLower);
    this->program.Set("averagedUpper", averagedUpper);
  }
}

void RayMarcher::SetLightUniforms(const Frame& frame)
{
  this->program.Set("worldFromGradient", frame.geometry.WorldFromGridNormal());
  const HeadLightColors light = HeadLightColorsOf(frame.renderer);
  this->program.Set("diffuseLight", light.diffuse);
  this->program.Set("specularLight", light.specular);
  if (frame.settings.damping)
  {
    const double scalarPerTexel = this->blocks.Texels().mapping.scale;
    this->program.Set(
      "dampingFactors", frame.geometry.gradientFactors * (scalarPerTexel / frame.dampingGradient));
  }
  if (!frame.settings.lights)
  {
    return;
  }
  const LightTexels others = LightTexelsOf(frame.renderer);
  this->lights.Texture()->Activate();
  this->program.Set("lightTexels", this->lights.Texture());
  this->program.Set("distantCount", others.distantCount);
  this->program.Set("nearCount", others.nearCount);
  this->program.Set("ambientLight", AmbientLightOf(frame.renderer));
  this->program.Set("backsLit", frame.renderer->GetTwoSidedLighting() ? 1.0 : 0.0);
  this->program.Set("worldOfGridOrigin", glm::dvec3(frame.geometry.worldFromGrid[3]));
}

void RayMarcher::SetGradientOpacityUniforms(const Frame& frame)
{
  const double last = GradientOpacityEntryCount - 1;
  glm::dvec4 entriesPerGradient(0.0);
  for (int part = 0; part < PartCount(frame.settings); ++part)
  {
    const ScalarTexels& texels =
      this->blocks.TexelsOfChannels()[OpacityComponentOf(frame.settings, part)];
    entriesPerGradient[part] = texels.mapping.scale / LargestGradient(texels) * last;
  }
  this->gradientOpacity.Texture()->Activate();
  this->program.Set("gradientOpacityTable", this->gradientOpacity.Texture());
  this->program.Set("lastGradientEntry", last);
  this->program.Set("spacingFactors", frame.geometry.gradientFactors);
  this->program.Set("entriesPerGradient", entriesPerGradient);
  this->program.Set("opacityUnitDistancesMm", UnitDistancesOf(frame));
}

}
