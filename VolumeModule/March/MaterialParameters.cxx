#include "March/MaterialParameters.h"

#include "Core/Recipe/ShaderRecipe.h"
#include "Frame/ComponentFunctions.h"

#include "vtkDataArray.h"
#include "vtkRenderer.h"
#include "vtkVolumeProperty.h"

#include <algorithm>

namespace varimarch
{

namespace
{

// Scale and bias that map a texel to the position of its scalar in the range, [0, 1].
glm::dvec2 PlaceInRange(const ScalarTexels& texels, const TexelMapping& mapping)
{
  const double range = texels.largestScalar - texels.smallestScalar;
  const double perValue = range > 0.0 ? 1.0 / range : 0.0;
  return { mapping.scale * perValue, (mapping.offset - texels.smallestScalar) * perValue };
}

// The last index of the table that a scalar is looked up in.
double LastIndexOf(
  const VolumeMarch& march, const VolumeResources& volume, const OpticalTable& table)
{
  return UsesPreIntegration(march.settings)
    ? volume.Materials().PreIntegrated().EntriesPerSide() - 1.0
    : double(table.entries.size()) - 1.0;
}

void SetVisible(VolumeParameters& p, int component, const TexelMapping& mapping,
  const std::array<double, 2>& visible)
{
  p.visibleLower[component] = float(mapping.LimitedTexelOf(visible[0]));
  p.visibleUpper[component] = float(mapping.LimitedTexelOf(visible[1]));
}

void SetVisibleOfComponents(
  VolumeParameters& p, const VolumeResources& volume, const Mappings& mappings)
{
  p.visibleLower = glm::vec4(1e30f); // nothing is visible
  p.visibleUpper = glm::vec4(-1e30f);
  for (std::size_t i = 0; i < volume.Materials().MaterialTables().size(); ++i)
  {
    const MaterialTable& table = volume.Materials().MaterialTables()[i];
    if (table.decidesOnOpacity)
    {
      SetVisible(p, table.component, mappings[table.component],
        volume.Materials().OpticalTables().VisibleValues(i));
    }
  }
}

void SetColors(VolumeParameters& p, const VolumeMarch& march, const Mappings& mappings)
{
  constexpr double Most = 1e30; // a float
  const double largest = LargestColorOf(march.frame.voxels.components);
  for (int i = 0; i < 3; ++i)
  {
    p.colorScale[i] = float(std::min(mappings[i].scale / largest, Most));
    p.colorBias[i] = float(std::clamp(mappings[i].offset / largest, -Most, Most));
  }
}

void SetTwoValues(VolumeParameters& p, const VolumeResources& volume, const Mappings& mappings)
{
  const std::vector<ScalarTexels>& texels = volume.Blocks().TexelsOfComponents();
  p.twoValueTableSize = glm::dvec2(volume.Materials().TwoValuesSize());
  p.placeFromScalar = PlaceInRange(texels.front(), mappings.front());
  p.placeFromSecond = PlaceInRange(texels.back(), mappings.back());
  p.placePerGradient = float(mappings.front().scale / LargestGradient(texels.front()));
}

// Normals are computed from texels, because products of gradients in data units could overflow.
void SetLights(VolumeParameters& p, const VolumeMarch& march, const VolumeResources& volume,
  const Mappings& mappings)
{
  const double texelsPerScalar = mappings.front().scale / volume.Blocks().Texels().mapping.scale;
  p.worldFromGradient = march.frame.geometry.WorldFromGridNormal() * texelsPerScalar;
  p.diffuseLight = march.frame.lights.head.diffuse;
  p.specularLight = march.frame.lights.head.specular;
  constexpr double Undamped = 1e8;
  constexpr double Most = 1e30;
  p.labelGradient = float(std::min(Undamped / texelsPerScalar, Most));
  if (march.settings.damping)
  {
    p.dampingFactors = march.frame.geometry.gradientFactors *
      (mappings.front().scale / march.frame.material.dampingGradient);
  }
  if (march.settings.lights)
  {
    p.ambientLight = march.frame.lights.ambient;
    p.scatteredPart = float(march.frame.material.scatteredPart);
    p.anisotropy = float(march.frame.material.anisotropy);
    p.surfacesInShadow = float(march.frame.material.surfacesInShadow);
    p.backsLit = march.frame.lights.areTwoSided ? 1.0f : 0.0f;
  }
}

// The lights to which rays go through the volume.
void SetLamps(VolumeParameters& p, const VolumeMarch& march)
{
  const LightTexels& lamps = march.frame.lights.lamps;
  p.distantCount = lamps.distantCount;
  p.nearCount = lamps.nearCount;
  p.originInCasters =
    glm::dvec3(march.frame.geometry.worldFromGrid[3]) - march.frame.casters.originWorld;
  constexpr double BeyondAll = 3e38;
  p.shadowReachMm = float(std::min(march.frame.material.shadowReachMm, BeyondAll));
}

// The emission and extinction of an entry that holds a color and an extinction.
glm::vec4 EmissionOf(const glm::vec4& entry)
{
  return { entry.w * glm::vec3(entry), entry.w };
}

// The weight of a part's extinction in the mixture.
double WeightOf(const VolumeMarch& march, int part)
{
  const bool isWeighted = march.settings.components == Components::Independent;
  return isWeighted ? march.frame.material.weights[part] : 1.0;
}

void SetGradientOpacity(VolumeParameters& p, const VolumeMarch& march,
  const VolumeResources& volume, const Mappings& mappings)
{
  p.lastGradientEntry = float(GradientOpacityTable::EntriesPerCurve - 1);
  for (int part = 0; part < PartCount(march.settings); ++part)
  {
    const int component = OpacityComponentOf(march.settings, part);
    p.entriesPerGradient[part] = float(
      mappings[component].scale / volume.Materials().LastGradient(part) * p.lastGradientEntry);
  }
}

}

void SetTables(VolumeParameters& p, const VolumeMarch& march, const VolumeResources& volume,
  const Mappings& mappings)
{
  const std::vector<OpticalTable>& tables = volume.Materials().OpticalTables().Tables();
  if (march.settings.functionOf != FunctionOf::Value)
  {
    SetTwoValues(p, volume, mappings);
  }
  // The tables of labels have rows of their own.
  for (std::size_t i = 0; i < std::min<std::size_t>(tables.size(), 4); ++i)
  {
    const OpticalTable& table = tables[i];
    const int component = volume.Materials().MaterialTables()[i].component;
    const double last = LastIndexOf(march, volume, table);
    const IndexInTable index =
      IndexOf(table, last, mappings[component].scale, mappings[component].offset);
    p.tableScales[i] = float(index.scale);
    p.tableBiases[i] = float(index.bias);
    p.lastTableIndices[i] = float(last);
    p.firstEntries[i] = float(volume.Materials().OpticalTables().FirstEntryOf(i));
  }
  p.emissionBelow = EmissionOf(tables.front().entries.front());
  p.emissionAbove = EmissionOf(tables.front().entries.back());
  if (march.settings.components == Components::One)
  {
    SetVisible(p, 0, mappings.front(), volume.Materials().OpticalTables().VisibleValuesOfAny());
  }
  else
  {
    SetVisibleOfComponents(p, volume, mappings);
  }
  if (march.settings.components == Components::Rgba)
  {
    SetColors(p, march, mappings);
  }
}

void SetMaterials(VolumeParameters& p, const VolumeMarch& march, const VolumeResources& volume,
  const Mappings& mappings)
{
  p.spacingFactors = march.frame.geometry.gradientFactors;
  p.clippedScalar = float(mappings.front().LimitedTexelOf(march.frame.material.clippedScalar));
  p.materialCount = PartCount(march.settings);
  p.isosurfaceCount = int(march.frame.material.isovalues.size());
  p.opacityUnitDistancesMm = glm::vec4(1.0f);
  p.partWeights = glm::vec4(1.0f);
  for (int part = 0; part < PartCount(march.settings); ++part)
  {
    vtkVolumeProperty* const property = march.frame.material.property;
    p.opacityUnitDistancesMm[part] =
      float(property->GetScalarOpacityUnitDistance(HasOpacities(property, part) ? part : 0));
    p.partWeights[part] = float(WeightOf(march, part));
    p.reflectances[part] = march.frame.material.reflectances[part];
  }
  if (march.settings.blend == Blend::Isosurface)
  {
    p.reflectances[0] = march.frame.material.reflectances[march.frame.material.surfaceComponent];
  }
  if (march.settings.shading)
  {
    SetLights(p, march, volume, mappings);
  }
  if (march.settings.lights || march.settings.shadowsOthers)
  {
    SetLamps(p, march);
  }
  if (march.settings.gradientOpacity)
  {
    SetGradientOpacity(p, march, volume, mappings);
  }
}

}
