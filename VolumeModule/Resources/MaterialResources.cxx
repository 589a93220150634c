#include "Resources/MaterialResources.h"

#include "Core/Recipe/ShaderRecipe.h"
#include "Frame/PropertyTransferFunction.h"
#include "Resources/ProcessorVolume.h"
#include "Resources/ValueFocus.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace varimarch
{

namespace
{

// A side of a pre-integrated table has this many entries between two nodes of the transfer
// function, but at least these. A smaller table fits better into the processor's caches.
constexpr double PreIntegratedPerGap = 64.0;
constexpr std::size_t FewestPreIntegrated = 256;

std::size_t PreIntegratedEntries(const VolumeMarch& march, const OpticalTable& table)
{
  const TransferFunction function = TransferFunctionOf(march.frame.material.property);
  const double range = table.lastValue - table.firstValue;
  std::size_t side = function.IsPiecewiseLinear() ? FewestPreIntegrated : MostPreIntegratedValues;
  while (side < MostPreIntegratedValues &&
    side * function.SmallestNodeGap() < PreIntegratedPerGap * range)
  {
    side *= 2;
  }
  side /= march.plan.hasSmallTable ? 2 : 1;
  return side * side;
}

// The table of isosurfaces. Each has two entries: its colour and optical depth, and its isovalue.
std::vector<glm::vec4> IsosurfaceEntriesOf(const Frame& frame, const TexelMapping& mapping)
{
  const TransferFunction transferFunction =
    TransferFunctionOf(frame.material.property, frame.material.surfaceComponent);
  std::vector<glm::vec4> entries;
  for (double isovalue : frame.material.isovalues)
  {
    const double depth = -std::log1p(-transferFunction.Opacity(isovalue));
    entries.emplace_back(transferFunction.Color(isovalue), std::min(depth, 100.0));
    entries.emplace_back(mapping.LimitedTexelOf(isovalue));
  }
  return entries;
}

}

void MaterialResources::Update(const VolumeMarch& march, const std::vector<ScalarTexels>& texels)
{
  this->UpdateOpticalTable(march, texels);
  this->mergesValues =
    march.plan.marcher == Marcher::Device && varimarch::MergesValues(march.frame, texels);
  this->gradientOpacity.Update(march, texels);
  this->UpdateLights(march);
  this->UpdateIsosurfaces(march, texels);
}

void MaterialResources::UpdateOpticalTable(
  const VolumeMarch& march, const std::vector<ScalarTexels>& texels)
{
  const Fingerprint inputs = MaterialTableInputs(march.frame.material.property, march.settings);
  if (this->tableOfProperty != march.frame.material.property || this->tableOfTexels != texels ||
    this->tableInputs != inputs)
  {
    this->opticalTable.SetTables(march.frame.view.window, this->BuildTables(march, texels));
    this->tableOfTexels = texels; // they have the range that the table spans
    this->tableOfProperty = march.frame.material.property;
    this->tableInputs = inputs;
    ++this->tableBuilds;
  }
  this->twoValues.Update(march.frame.view.window, march.plan.marcher);
  if (march.plan.marcher == Marcher::Processor)
  {
    this->opticalTable.ReleaseTexture(march.frame.view.window);
  }
  else if (march.settings.mask == Mask::Labels)
  {
    this->opticalTable.UploadRows(march.frame.view.window, texels.front().mapping);
  }
  else
  {
    this->opticalTable.Upload(march.frame.view.window);
  }
}

std::vector<OpticalTable> MaterialResources::BuildTables(
  const VolumeMarch& march, const std::vector<ScalarTexels>& texels)
{
  this->twoValues.Release(march.frame.view.window);
  // All tables share MostEntries, but each has at least FewestEntries.
  constexpr std::size_t MostEntries = 65536;
  constexpr std::size_t FewestEntries = 256;
  this->materialTables = MaterialTablesOf(march.frame.material.property, march.settings);
  const std::size_t entries = std::max(MostEntries / this->materialTables.size(), FewestEntries);
  std::vector<OpticalTable> tables;
  if (march.settings.functionOf != FunctionOf::Value)
  {
    tables.push_back(this->BuildTwoValues(march, texels.front()));
  }
  while (tables.size() < this->materialTables.size())
  {
    const MaterialTable& table = this->materialTables[tables.size()];
    const ValueRange& range = texels[table.component].resolved;
    tables.push_back(BuildOpticalTable(table.transferFunction, range.lower, range.upper, entries));
  }
  return tables;
}

OpticalTable MaterialResources::BuildTwoValues(const VolumeMarch& march, const ScalarTexels& texels)
{
  vtkVolumeProperty* const property = march.frame.material.property;
  TwoValueTable table = TwoValueTableOf(property);
  OpticalTable bound = UpperBound(table, { texels.smallestScalar, texels.largestScalar },
    property->GetScalarOpacityUnitDistance());
  this->twoValuesSize = table.size;
  this->twoValues.Set(march.frame.view.window, std::move(table.entries));
  return bound;
}

double MaterialResources::MostExtinction() const
{
  double most = 0.0;
  for (const OpticalTable& table : this->opticalTable.Tables())
  {
    for (const glm::vec4& entry : table.entries)
    {
      most = std::max(most, double(entry.w));
    }
  }
  return most;
}

bool MaterialResources::MissesCurve() const
{
  const std::vector<OpticalTable>& tables = this->opticalTable.Tables();
  return std::any_of(
    tables.begin(), tables.end(), [](const OpticalTable& table) { return table.missesCurve; });
}

void MaterialResources::UpdatePreIntegrated(const VolumeMarch& march)
{
  if (!UsesPreIntegration(march.settings))
  {
    this->preIntegratedTable.Release(march.frame.view.window);
    this->preIntegratedOfTable = 0;
  }
  else if (this->preIntegratedOfTable != this->tableBuilds ||
    this->preIntegratedIsSmall != march.plan.hasSmallTable ||
    this->preIntegratedTable.IsKept() != (march.plan.marcher == Marcher::Processor))
  {
    const OpticalTable& optical = this->opticalTable.Table();
    PreIntegratedTable table =
      BuildPreIntegratedTable(optical, PreIntegratedEntries(march, optical));
    march.plan.marcher == Marcher::Processor
      ? this->preIntegratedTable.Keep(march.frame.view.window, std::move(table))
      : this->preIntegratedTable.Upload(march.frame.view.window, std::move(table));
    this->preIntegratedOfTable = this->tableBuilds;
    this->preIntegratedIsSmall = march.plan.hasSmallTable;
  }
}

void MaterialResources::UpdateLights(const VolumeMarch& march)
{
  this->lights.Set(march.frame.view.window,
    march.settings.lights || march.settings.shadowsOthers ? march.frame.lights.lamps.texels
                                                          : std::vector<glm::vec4>());
  this->lights.Update(march.frame.view.window, march.plan.marcher);
}

void MaterialResources::UpdateIsosurfaces(
  const VolumeMarch& march, const std::vector<ScalarTexels>& texels)
{
  const TexelMapping mapping = march.plan.marcher == Marcher::Device
    ? texels.front().mapping
    : MappingsForPackets(texels, march.frame.voxels.components).front();
  this->isosurfaces.Set(march.frame.view.window,
    march.settings.blend == Blend::Isosurface ? IsosurfaceEntriesOf(march.frame, mapping)
                                              : std::vector<glm::vec4>());
  this->isosurfaces.Update(march.frame.view.window, march.plan.marcher);
}

VolumeTextures MaterialResources::Textures() const
{
  VolumeTextures textures = {};
  textures.opticalTable.onDevice = this->opticalTable.Texture();
  textures.preIntegratedTable.onDevice = this->preIntegratedTable.Texture();
  textures.twoValueTable = this->twoValues.Texture();
  textures.gradientOpacityTable = this->gradientOpacity.Texture();
  textures.lightTexels = this->lights.Texture();
  textures.isosurfaces = this->isosurfaces.Texture();
  return textures;
}

std::size_t MaterialResources::Bytes() const
{
  return this->opticalTable.Bytes() + this->twoValues.Bytes() + this->gradientOpacity.Bytes() +
    this->lights.Bytes() + this->isosurfaces.Bytes();
}

void MaterialResources::Release(vtkWindow* window)
{
  this->opticalTable.Release(window);
  this->tableOfTexels.clear();
  this->preIntegratedTable.Release(window);
  this->preIntegratedOfTable = 0;
  this->twoValues.Release(window);
  this->gradientOpacity.Release(window);
  this->lights.Release(window);
  this->isosurfaces.Release(window);
}

}
