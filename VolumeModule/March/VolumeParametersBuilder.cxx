#include "March/VolumeParametersBuilder.h"

#include "Core/Recipe/ShaderRecipe.h"
#include "March/SkyParameters.h"

#include "vtkDataArray.h"
#include "vtkRenderer.h"

#include <glm/common.hpp>
#include <glm/matrix.hpp>

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
    const MaterialFunction& table = volume.Materials().MaterialTables()[i];
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

/// Sets the parameters of the tables that scalars are looked up in.
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

/// Sets the parameters of lights, gradient opacity and mixtures.
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
    p.opacityUnitDistancesMm[part] =
      float(march.frame.material.functions.opacityUnitDistancesMm[std::size_t(part)]);
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

void SetPlace(VolumeParameters& p, const VolumeMarch& march, const VoxelRegion& voxels)
{
  p.worldFromGrid = march.frame.geometry.WorldFromGridDirection();
  p.gridFromWorld = glm::inverse(march.frame.geometry.WorldFromGridDirection());
  p.worldOfGridOrigin = glm::dvec3(march.frame.geometry.worldFromGrid[3]);
  p.firstVoxelGrid = glm::dvec3(voxels.first);
  p.voxelCount = glm::dvec3(voxels.count);
  p.voxelCountInverse = 1.0 / glm::dvec3(voxels.count);
}

void SetField(VolumeParameters& p, glm::ivec3 size, int cellsPerBrick)
{
  p.fieldSize = glm::dvec3(size);
  p.fieldSizeInverse = 1.0 / glm::dvec3(size);
  p.cellsPerBrick = float(cellsPerBrick);
}

void SetExtreme(VolumeParameters& p, const VolumeMarch& march, const VolumeResources& volume,
  const TexelMapping& first)
{
  p.sense = march.settings.blend == Blend::MaximumIntensity ? 1.0f : -1.0f;
  if (march.settings.acceleration == Acceleration::OpticalField)
  {
    const ExtremeSteps steps = volume.Fields().ExtremeStepsOf(march.settings.blend);
    p.scalarFromField =
      glm::dvec2(steps.valuePerStep / first.scale, (steps.firstValue - first.offset) / first.scale);
  }
}

// Maximum and minimum use the range of all interpolated values, average and sum the range that they
// show in gray.
void SetProjection(VolumeParameters& p, const VolumeMarch& march, const VolumeResources& volume,
  const Mappings& mappings)
{
  const bool isExtreme = IsExtreme(march.settings.blend);
  const std::vector<ScalarTexels>& texels = volume.Blocks().TexelsOfComponents();
  for (int i = 0; i < int(texels.size()); ++i)
  {
    const TexelMapping& mapping = mappings[i];
    const double smallest =
      mapping.LimitedTexelOf(isExtreme ? texels[i].smallestValue : texels[i].gray.lower);
    const double largest =
      mapping.LimitedTexelOf(isExtreme ? texels[i].largestValue : texels[i].gray.upper);
    p.smallestScalars[i] = float(smallest);
    p.largestScalars[i] = float(largest);
    p.grayPerScalars[i] = float(largest > smallest ? 1.0 / (largest - smallest) : 0.0);
    p.averagedLower[i] = float(mapping.LimitedTexelOf(march.frame.material.averagedRange[0]));
    p.averagedUpper[i] = float(mapping.LimitedTexelOf(march.frame.material.averagedRange[1]));
  }
}

void SetGaps(VolumeParameters& p, const VolumeMarch& march, glm::ivec3 cells)
{
  p.gapCellCount = glm::dvec3(cells);
  p.gapCellCountInverse = 1.0 / glm::dvec3(cells);
  p.gapShift = march.frame.voxels.blanking.IsOfVoxels() ? 0.5f : 0.0f;
  p.gapOptical = FillsGaps(march.settings) ? march.frame.material.gapOptical : glm::dvec4(0.0);
}

void SetMask(VolumeParameters& p, const VolumeMarch& march, const VolumeResources& volume)
{
  const glm::dvec3 size(volume.Mask().Size());
  p.maskVoxelCount = size;
  p.maskVoxelsPerVoxel = size / glm::dvec3(march.frame.geometry.dimensions);
  p.labelPart = float(march.frame.material.labelBlend);
  p.leastContent = march.settings.mask == Mask::Binary ? 0.5f : -1.0f;
}

void SetSpacing(VolumeParameters& p, const VolumeMarch& march, const UnevenBins& bins)
{
  p.spacingFirstBins = glm::dvec3(bins.first);
  p.spacingLastBins = glm::dvec3(bins.last);
  p.spacingLowerGrid = bins.lowerGrid;
  p.spacingBinsPerGrid = bins.binsPerGrid;
  p.spacingVoxelCount = glm::dvec3(march.frame.geometry.dimensions);
}

void SetSlice(VolumeParameters& p, const SliceSurface& slice)
{
  p.sliceMatrix = slice.matrix;
  p.sliceCenterGrid = slice.centerGrid;
}

}

MarchedVolume VolumeOfShaders(const VolumeMarch& march, const VolumeResources& volume,
  const VolumeBlock* block, const VoxelRegion& voxels)
{
  MarchedVolume marched{ {}, voxels, volume.Fields().OfBricks().Size(), glm::ivec3(1) };
  for (const ScalarTexels& texels : volume.Blocks().TexelsOfComponents())
  {
    marched.mappings.push_back(texels.mapping);
  }
  if (block)
  {
    const bool isOfValues = IsOfValues(march.settings.acceleration);
    marched.fieldSize = isOfValues ? block->valueField.Size() : marched.fieldSize;
    marched.gapCells = block->gaps.Size();
  }
  return marched;
}

MarchedVolume VolumeOfProcessor(const VolumeResources& volume)
{
  return { volume.Packets().Mappings(), { glm::ivec3(0), volume.Packets().VoxelCount() },
    volume.Fields().OfBricks().Size(), volume.Packets().GapCells() };
}

VolumeParameters VolumeParametersOf(
  const VolumeMarch& march, const VolumeResources& volume, const MarchedVolume& marched)
{
  const Mappings& mappings = marched.mappings;
  VolumeParameters p = {};
  SetPlace(p, march, marched.voxels);
  SetField(p, marched.fieldSize, volume.Fields().OfBricks().CellsPerBrick());
  SetTables(p, march, volume, mappings);
  SetMaterials(p, march, volume, mappings);
  if (IsExtreme(march.settings.blend))
  {
    SetExtreme(p, march, volume, mappings.front());
  }
  SetProjection(p, march, volume, mappings);
  SetSky(p, march, volume.Light().Sky(march));
  SetGaps(p, march, marched.gapCells);
  SetMask(p, march, volume);
  SetSpacing(p, march, volume.SpacingBins());
  SetSlice(p, march.frame.material.slice);
  p.ownLowerGrid = volume.Division().VisibleBox().lower;
  p.ownUpperGrid =
    glm::max(volume.Division().VisibleBox().lower, volume.Division().VisibleBox().upper);
  p.ownGridFromRays = glm::dmat4(1.0);
  return p;
}

}
