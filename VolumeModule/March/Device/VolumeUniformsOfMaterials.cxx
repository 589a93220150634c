// Of materials: what gives a point of the volume its look beyond one transfer function.

#include "March/Device/VolumeUniforms.h"

#include "Core/Recipe/ShaderRecipe.h"
#include "Frame/Lights.h"

#include "vtkDataArray.h"
#include "vtkRenderer.h"
#include "vtkVolumeProperty.h"

#include <glm/matrix.hpp>

#include <algorithm>

namespace varimarch
{

namespace
{

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
    weights[part] = WeightOf(frame.property, frame.settings, part);
  }
  return weights;
}

}

void VolumeUniforms::SetMaterial(const DrawnBlock& drawn)
{
  this->program.Set("voxelSizeTexture", 1.0 / glm::dvec3(drawn.voxels.count));
  if (this->frame.settings.components != Components::One)
  {
    this->SetComponents();
  }
  else
  {
    const std::array<double, 2> visible = this->resources.OpticalTables().VisibleValuesOfAny();
    const TexelMapping& mapping = this->resources.Blocks().Texels().mapping;
    this->program.Set("visibleScalars",
      glm::dvec2(mapping.LimitedTexelOf(visible[0]), mapping.LimitedTexelOf(visible[1])));
    this->program.Set("reflectance", ReflectanceOf(this->frame.property, 0));
  }
  if (this->frame.settings.shading)
  {
    this->SetLights();
  }
  if (this->frame.settings.gradientOpacity)
  {
    this->SetGradientOpacity();
  }
}

void VolumeUniforms::SetComponentTables()
{
  std::array<glm::dvec2, 4> fromScalar = {};
  std::array<double, 4> first = {};
  std::array<double, 4> last = {};
  for (std::size_t i = 0; i < this->resources.MaterialTables().size(); ++i)
  {
    const OpticalTable& table = this->resources.OpticalTables().Tables()[i];
    const int channel = this->resources.MaterialTables()[i].channel;
    const TexelMapping& mapping = this->resources.Blocks().TexelsOfChannels()[channel].mapping;
    const double extent = table.lastValue - table.firstValue;
    last[i] = double(table.entries.size() - 1);
    first[i] = double(this->resources.OpticalTables().FirstEntryOf(i));
    const double indexPerValue = extent > 0.0 ? last[i] / extent : 0.0;
    fromScalar[i] = { mapping.scale * indexPerValue,
      (mapping.offset - table.firstValue) * indexPerValue };
  }
  this->resources.OpticalTables().Texture()->Activate();
  this->program.Set("opticalTable", this->resources.OpticalTables().Texture());
  this->program.Set("tablesFromScalar", fromScalar);
  this->program.Set("firstEntries", first);
  this->program.Set("lastTableIndices", last);
  const std::vector<ScalarTexels>& texels = this->resources.Blocks().TexelsOfChannels();
  if (this->resources.MaterialTables().front().channel == 3)
  {
    const double largest = LargestColorOf(this->frame.channels.front().array);
    const TexelMapping mappings[] = { texels[0].mapping, texels[1].mapping, texels[2].mapping };
    this->program.Set(
      "colorScale", glm::dvec3(mappings[0].scale, mappings[1].scale, mappings[2].scale) / largest);
    this->program.Set("colorBias",
      glm::dvec3(mappings[0].offset, mappings[1].offset, mappings[2].offset) / largest);
  }
}

void VolumeUniforms::SetComponents()
{
  std::array<glm::dvec2, 4> visibleScalars;
  visibleScalars.fill({ 1e30, -1e30 }); // none
  for (std::size_t i = 0; i < this->resources.MaterialTables().size(); ++i)
  {
    const MaterialTable& table = this->resources.MaterialTables()[i];
    if (table.decidesOnOpacity)
    {
      const TexelMapping& mapping =
        this->resources.Blocks().TexelsOfChannels()[table.channel].mapping;
      const std::array<double, 2>& visible = this->resources.OpticalTables().VisibleValues(i);
      visibleScalars[table.channel] = { mapping.LimitedTexelOf(visible[0]),
        mapping.LimitedTexelOf(visible[1]) };
    }
  }
  std::array<glm::dvec4, 4> reflectances = {};
  for (int part = 0; part < PartCount(this->frame.settings); ++part)
  {
    reflectances[part] = ReflectanceOf(this->frame.property, part);
  }
  this->program.Set("visibleScalarsOf", visibleScalars);
  this->program.Set("reflectances", reflectances);
  this->program.Set("partWeights", WeightsOf(this->frame));
}

void VolumeUniforms::SetComponentProjection()
{
  const std::vector<ScalarTexels>& channels = this->resources.Blocks().TexelsOfChannels();
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
    averagedLower[i] = mapping.LimitedTexelOf(this->frame.averagedRange[0]);
    averagedUpper[i] = mapping.LimitedTexelOf(this->frame.averagedRange[1]);
  }
  this->program.Set("partWeights", WeightsOf(this->frame));
  this->program.Set("opacityUnitDistancesMm", UnitDistancesOf(this->frame));
  if (IsExtreme(this->frame.settings.blend))
  {
    const bool isMaximum = this->frame.settings.blend == Blend::MaximumIntensity;
    this->program.Set("sense", isMaximum ? 1.0 : -1.0);
    this->program.Set("leastExtremes", isMaximum ? leastMaximum : mostMinimum);
    return;
  }
  this->program.Set("smallestScalars", smallest);
  this->program.Set("grayPerScalars", grayPerScalar);
  if (this->frame.settings.blend == Blend::AverageIntensity)
  {
    this->program.Set("averagedLower", averagedLower);
    this->program.Set("averagedUpper", averagedUpper);
  }
}

void VolumeUniforms::SetLights()
{
  this->program.Set("worldFromGradient", this->frame.geometry.WorldFromGridNormal());
  const HeadLightColors light = HeadLightColorsOf(this->frame.renderer);
  this->program.Set("diffuseLight", light.diffuse);
  this->program.Set("specularLight", light.specular);
  if (this->frame.settings.damping)
  {
    const double scalarPerTexel = this->resources.Blocks().Texels().mapping.scale;
    this->program.Set("dampingFactors",
      this->frame.geometry.gradientFactors * (scalarPerTexel / this->frame.dampingGradient));
  }
  if (!this->frame.settings.lights)
  {
    return;
  }
  const LightTexels others = LightTexelsOf(this->frame.renderer);
  this->resources.LightTexels().Texture()->Activate();
  this->program.Set("lightTexels", this->resources.LightTexels().Texture());
  this->program.Set("distantCount", others.distantCount);
  this->program.Set("nearCount", others.nearCount);
  this->program.Set("ambientLight", AmbientLightOf(this->frame.renderer));
  this->program.Set("backsLit", this->frame.renderer->GetTwoSidedLighting() ? 1.0 : 0.0);
  this->program.Set("worldOfGridOrigin", glm::dvec3(this->frame.geometry.worldFromGrid[3]));
}

void VolumeUniforms::SetGradientOpacity()
{
  const double last = VolumeResources::EntriesPerGradientCurve - 1;
  glm::dvec4 entriesPerGradient(0.0);
  for (int part = 0; part < PartCount(this->frame.settings); ++part)
  {
    const ScalarTexels& texels =
      this->resources.Blocks().TexelsOfChannels()[OpacityComponentOf(this->frame.settings, part)];
    entriesPerGradient[part] = texels.mapping.scale / LargestGradient(texels) * last;
  }
  this->resources.GradientOpacity().Texture()->Activate();
  this->program.Set("gradientOpacityTable", this->resources.GradientOpacity().Texture());
  this->program.Set("lastGradientEntry", last);
  this->program.Set("spacingFactors", this->frame.geometry.gradientFactors);
  this->program.Set("entriesPerGradient", entriesPerGradient);
  this->program.Set("opacityUnitDistancesMm", UnitDistancesOf(this->frame));
}

}
