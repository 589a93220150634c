#include "Resources/VolumeResources.h"

#include "Core/Geometry/SplineCoefficients.h"
#include "Core/Recipe/ShaderRecipe.h"
#include "Frame/Lights.h"
#include "Frame/PropertyTransferFunction.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace varimarch
{

namespace
{

// Entries of a pre-integrated table on a side: so many between two nodes of the transfer function,
// if these bounds allow it. The smaller it is, the more of it stays in the processor's caches.
constexpr double PreIntegratedPerGap = 64.0;
constexpr std::size_t FewestPreIntegrated = 256;
constexpr std::size_t MostPreIntegrated = 1024;

std::size_t PreIntegratedEntries(vtkVolumeProperty* property, const OpticalTable& table)
{
  const TransferFunction function = TransferFunctionOf(property);
  const double range = table.lastValue - table.firstValue;
  std::size_t side = function.IsPiecewiseLinear() ? FewestPreIntegrated : MostPreIntegrated;
  while (
    side < MostPreIntegrated && side * function.SmallestNodeGap() < PreIntegratedPerGap * range)
  {
    side *= 2;
  }
  return side * side;
}

}

void VolumeResources::UpdateVoxels(const Frame& frame)
{
  this->blocks.SetBlanking(frame.blanking);
  const bool isCubic = frame.settings.cubic;
  if (this->volumeSource == frame.components && this->volumeTime == frame.scalarsTime &&
    this->volumeIsCubic == isCubic)
  {
    return;
  }
  this->volumeSource.clear();
  const glm::ivec3 dimensions = frame.geometry.dimensions;
  this->spline = isCubic ? SplineVolume(frame.components, dimensions) : SplineVolume();
  this->blocks.SetVoxels(isCubic
      ? VoxelValues{ this->spline.Components(), dimensions, this->spline.Texels(frame.components),
          SplineReachVoxels }
      : VoxelValues{ frame.components, dimensions, ScalarTexelsOf(frame.components) });
  this->volumeSource = frame.components;
  this->volumeTime = frame.scalarsTime;
  this->volumeIsCubic = isCubic;
  this->tableSource = nullptr; // a table covers the range of the scalars
  this->voxelsAreFinite.reset();
  this->packetVoxels.clear();
  ++this->builds.volumeTexture;
}

void VolumeResources::Update(Frame& frame, const MemoryElsewhere& elsewhere)
{
  this->UpdateOpticalTable(frame);
  this->UpdateGradientOpacity(frame);
  this->UpdatePacketVoxels(frame);
  this->UpdateMask(frame);
  this->UpdateSpacing(frame);
  this->UpdateField(frame);
  frame.settings.skipsBricks = this->field.SkipsAny();
  this->UpdateLights(frame);
  this->UpdateIsosurfaces(frame);
  this->UpdateBlocks(frame, elsewhere);
  this->UpdatePacketGaps(frame);
}

void VolumeResources::UpdateOpticalTable(const Frame& frame)
{
  const std::vector<double> inputs = MaterialTableInputs(frame.property, frame.settings);
  if (this->tableSource != frame.property || this->tableInputs != inputs)
  {
    this->opticalTable.SetTables(frame.window, this->BuildTables(frame));
    this->tableSource = frame.property;
    this->tableInputs = inputs;
    ++this->builds.opticalTable;
  }
  this->twoValues.Update(frame.window, frame.marcher);
  if (frame.marcher == Marcher::Processor)
  {
    this->opticalTable.ReleaseTexture(frame.window);
  }
  else if (frame.settings.mask == Mask::Labels)
  {
    this->opticalTable.UploadRows(frame.window, this->blocks.Texels().mapping);
  }
  else
  {
    this->opticalTable.Upload(frame.window);
  }
}

void VolumeResources::UpdatePreIntegratedTable(const Frame& frame)
{
  if (!UsesPreIntegration(frame.settings))
  {
    this->preIntegratedTable.Release(frame.window);
    this->preIntegratedOfTable = 0;
  }
  else if (this->preIntegratedOfTable != this->builds.opticalTable ||
    this->preIntegratedTable.IsKept() != (frame.marcher == Marcher::Processor))
  {
    const OpticalTable& optical = this->opticalTable.Table();
    PreIntegratedTable table =
      BuildPreIntegratedTable(optical, PreIntegratedEntries(frame.property, optical));
    frame.marcher == Marcher::Processor
      ? this->preIntegratedTable.Keep(frame.window, std::move(table))
      : this->preIntegratedTable.Upload(frame.window, std::move(table));
    this->preIntegratedOfTable = this->builds.opticalTable;
  }
}

std::vector<OpticalTable> VolumeResources::BuildTables(const Frame& frame)
{
  const ScalarTexels& first = this->blocks.Texels();
  this->twoValues.Release(frame.window);
  if (frame.settings.functionOf != FunctionOf::Value)
  {
    TwoValueTable table = TwoValueTableOf(frame.property);
    const double unitDistanceMm = frame.property->GetScalarOpacityUnitDistance();
    this->materialTables = { { 0, TransferFunction({}, {}, unitDistanceMm), true } };
    OpticalTable bound =
      UpperBound(table, { first.smallestScalar, first.largestScalar }, unitDistanceMm);
    this->twoValuesSize = table.size;
    this->twoValues.Set(frame.window, std::move(table.entries));
    return { std::move(bound) };
  }
  constexpr std::size_t MostEntries = 65536; // of all tables together,
  constexpr std::size_t FewestEntries = 256; // but not less than these of each
  this->materialTables = MaterialTablesOf(frame.property, frame.settings);
  const std::size_t entries = std::max(MostEntries / this->materialTables.size(), FewestEntries);
  std::vector<OpticalTable> tables;
  for (const MaterialTable& table : this->materialTables)
  {
    const ScalarTexels& texels = this->blocks.TexelsOfComponents()[table.component];
    tables.push_back(BuildOpticalTable(
      table.transferFunction, texels.smallestValue, texels.largestValue, entries));
  }
  return tables;
}

void VolumeResources::UpdateMask(const Frame& frame)
{
  if (frame.settings.mask == Mask::None)
  {
    this->mask.Release(frame.window);
  }
  else
  {
    this->mask.Update(frame.window, frame.mask, frame.marcher);
  }
}

void VolumeResources::UpdateLights(const Frame& frame)
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

void VolumeResources::UpdateCuts(const Frame& frame)
{
  if (!frame.settings.clipping || frame.marcher == Marcher::Processor)
  {
    this->clippingPlanes.Release(frame.window);
    return;
  }
  const std::vector<glm::dvec4>& planes = frame.cuts.planesGrid;
  this->clippingPlanes.Upload(frame.window, std::vector<glm::vec4>(planes.begin(), planes.end()));
}

void VolumeResources::UpdateSpacing(const Frame& frame)
{
  UnevenBins uneven = BinsOf(frame.axes);
  if (uneven.bins != this->spacingBins.bins)
  {
    this->spacing.Release(frame.window);
    this->fieldSource.reset(); // bricks are of the even grid
    this->rangesOfVolume = 0;
  }
  this->spacingBins = std::move(uneven);
  if (frame.marcher == Marcher::Processor)
  {
    this->spacing.Release(frame.window);
  }
  else if (!this->spacingBins.bins.empty() && this->spacing.Bytes() == 0)
  {
    this->spacing.Upload(frame.window, this->spacingBins.bins);
  }
}

VoxelComponents VolumeResources::MarchedComponents() const
{
  return this->volumeIsCubic ? this->spline.Components() : this->volumeSource;
}

std::size_t VolumeResources::Bytes() const
{
  return this->BytesBesideBlocks() + this->preIntegratedTable.Bytes() + this->blocks.Bytes();
}

std::size_t VolumeResources::BytesBesideBlocks() const
{
  return this->clippingPlanes.Bytes() + this->isosurfaces.Bytes() + this->spacing.Bytes() +
    this->field.Bytes() + this->opticalTable.Bytes() + this->lights.Bytes() +
    this->gradientOpacity.Bytes() + this->twoValues.Bytes() + this->mask.Bytes();
}

std::vector<vtkTextureObject*> VolumeResources::Textures() const
{
  return { this->field.Texture(), this->opticalTable.Texture(), this->preIntegratedTable.Texture(),
    this->lights.Texture(), this->gradientOpacity.Texture(), this->twoValues.Texture(),
    this->mask.Texture(), this->clippingPlanes.Texture(), this->isosurfaces.Texture(),
    this->spacing.Texture() };
}

void VolumeResources::Release(vtkWindow* window)
{
  this->blocks.Release(window);
  this->field.Release(window);
  this->opticalTable.Release(window);
  this->preIntegratedTable.Release(window);
  this->lights.Release(window);
  this->gradientOpacity.Release(window);
  this->twoValues.Release(window);
  this->mask.Release(window);
  this->clippingPlanes.Release(window);
  this->isosurfaces.Release(window);
  this->spacing.Release(window);
  this->spline = SplineVolume();
  this->packetVoxels.clear();
  this->packetGaps = GapField();
  this->packetGapsOfVolume = 0;
  this->gradientOpacitySource.clear();
  this->spacingBins = UnevenBins();
  this->volumeSource.clear();
  this->visibleOfField = -1;
  this->fieldSource.reset();
  this->rangesOfVolume = 0;
  this->preIntegratedOfTable = 0;
}

}
