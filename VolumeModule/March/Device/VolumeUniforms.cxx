#include "March/Device/VolumeUniforms.h"

#include "Core/Recipe/ShaderRecipe.h"

#include "vtkVolumeProperty.h"

#include <glm/common.hpp>

namespace varimarch
{

void VolumeUniforms::SetPlace(const DrawnBlock& drawn)
{
  this->program.Set("worldFromGrid", this->frame.geometry.WorldFromGridDirection());
  this->program.Set("firstVoxelGrid", glm::dvec3(drawn.voxels.first));
  this->program.Set("voxelCountInverse", 1.0 / glm::dvec3(drawn.voxels.count));
}

void VolumeUniforms::SetOwnGrid(const glm::dmat4& gridFromRays)
{
  this->program.Set("ownGridFromRays", gridFromRays);
  this->program.Set("ownLowerGrid", this->resources.VisibleBox().lower);
  this->program.Set("ownUpperGrid",
    glm::max(this->resources.VisibleBox().lower, this->resources.VisibleBox().upper));
  this->program.Set("voxelCount", glm::dvec3(this->frame.geometry.dimensions));
}

void VolumeUniforms::SetCuts()
{
  if (this->frame.settings.clipping)
  {
    this->resources.ClippingPlanes().Texture()->Activate();
    this->program.Set("clippingPlanes", this->resources.ClippingPlanes().Texture());
    this->program.Set("clippingPlaneCount", int(this->frame.cuts.planesGrid.size()));
    this->program.Set("clippedScalar",
      this->resources.Blocks().Texels().mapping.LimitedTexelOf(
        this->frame.property->GetClippedVoxelIntensity()));
  }
  if (this->frame.settings.cropping && this->frame.settings.pass != RayPass::Picture)
  {
    this->program.Set("croppingPlanes", this->frame.cuts.regions->planesGrid);
    this->program.Set("croppingRegions", this->frame.cuts.regions->drawn);
  }
}

void VolumeUniforms::SetBlend()
{
  if (this->frame.settings.windowLevel)
  {
    this->program.Set("windowScaleBias", this->frame.windowScaleBias);
  }
  if (this->frame.settings.blend == Blend::Composite || IsOfSurfaces(this->frame.settings.blend))
  {
    this->program.Set("earlyTerminationTransmittance", this->frame.earlyTerminationTransmittance);
    return;
  }
  if (this->frame.settings.components != Components::One)
  {
    this->SetComponentProjection();
    return;
  }
  this->SetProjection();
}

void VolumeUniforms::SetProjection()
{
  const TexelMapping& mapping = this->resources.Blocks().Texels().mapping;
  const ScalarTexels& texels = this->resources.Blocks().Texels();
  const bool isExtreme = IsExtreme(this->frame.settings.blend);
  const double smallest = mapping.TexelOf(isExtreme ? texels.smallestValue : texels.smallestScalar);
  const double largest = mapping.TexelOf(isExtreme ? texels.largestValue : texels.largestScalar);
  this->program.Set("smallestScalar", smallest);
  this->program.Set("opacityUnitDistanceMm", this->frame.property->GetScalarOpacityUnitDistance());
  switch (this->frame.settings.blend)
  {
    case Blend::AverageIntensity:
      this->program.Set("averagedScalars",
        glm::dvec2(mapping.LimitedTexelOf(this->frame.averagedRange[0]),
          mapping.LimitedTexelOf(this->frame.averagedRange[1])));
      [[fallthrough]];
    case Blend::Additive:
      this->program.Set("grayPerScalar", largest > smallest ? 1.0 / (largest - smallest) : 0.0);
      break;
    default:
      this->program.Set("largestScalar", largest);
  }
}

void VolumeUniforms::SetMarch(const DrawnBlock& drawn)
{
  const VolumeTexture& volume = drawn.block->volume;
  const int filter =
    this->frame.settings.nearest ? vtkTextureObject::Nearest : vtkTextureObject::Linear;
  volume.Texture()->SetMinificationFilter(filter);
  volume.Texture()->SetMagnificationFilter(filter);
  volume.Texture()->Activate();
  this->program.Set("volumeTexture", volume.Texture());
  if (!IsSampled(this->frame.settings))
  {
    this->SetExact(drawn);
  }
  if (this->frame.settings.cubic)
  {
    this->program.Set("splineVoxelCount", glm::dvec3(drawn.voxels.count));
  }
  if (this->frame.settings.uneven)
  {
    this->SetSpacing();
  }
  this->SetSteps(*drawn.block);
  if (UsesPreIntegration(this->frame.settings))
  {
    this->SetPreIntegrated();
  }
  else
  {
    this->SetClassify();
  }
  if (MarchesMaterial(this->frame.settings))
  {
    this->SetMaterial(drawn);
  }
  if (this->frame.settings.gaps)
  {
    this->SetGaps(drawn);
  }
  if (this->frame.settings.mask != Mask::None)
  {
    this->SetMask();
  }
}

void VolumeUniforms::SetExact(const DrawnBlock& drawn)
{
  this->program.Set("voxelCount", glm::dvec3(drawn.voxels.count));
  if (this->frame.settings.blend == Blend::Slice)
  {
    this->program.Set("sliceMatrix", this->frame.slice.matrix);
    this->program.Set("sliceCenterGrid", this->frame.slice.centerGrid);
    this->program.Set("sliceUnitDistanceMm", this->frame.property->GetScalarOpacityUnitDistance());
  }
  if (this->frame.settings.blend != Blend::Isosurface)
  {
    return;
  }
  this->resources.Isosurfaces().Texture()->Activate();
  this->program.Set("isosurfaces", this->resources.Isosurfaces().Texture());
  this->program.Set("isosurfaceCount", int(this->frame.isovalues.size()));
  this->program.Set("voxelSizeTexture", 1.0 / glm::dvec3(drawn.voxels.count));
  this->program.Set(
    "surfaceReflectance", ReflectanceOf(this->frame.property, this->frame.surfaceComponent));
  if (this->frame.settings.shading)
  {
    this->SetLights();
  }
}

void VolumeUniforms::SetSpacing()
{
  const UnevenBins& bins = this->resources.SpacingBins();
  this->resources.Spacing().Texture()->Activate();
  this->program.Set("spacingTable", this->resources.Spacing().Texture());
  this->program.Set("spacingFirstBins", glm::dvec3(bins.first));
  this->program.Set("spacingLastBins", glm::dvec3(bins.last));
  this->program.Set("spacingLowerGrid", bins.lowerGrid);
  this->program.Set("spacingBinsPerGrid", bins.binsPerGrid);
  this->program.Set("spacingVoxelCount", glm::dvec3(this->frame.geometry.dimensions));
}

void VolumeUniforms::SetSteps(const VolumeBlock& block)
{
  this->program.Set("stepMm", this->frame.sampleDistanceMm);
  const bool isOfCells = this->frame.settings.acceleration == Acceleration::ScalarField;
  const bool isOfBricks = this->frame.settings.acceleration == Acceleration::OpticalField &&
    this->frame.settings.skipsBricks;
  if (!isOfCells && !isOfBricks)
  {
    return;
  }
  const AccelerationField& field = isOfCells ? block.scalarField : this->resources.Field();
  field.Texture()->Activate();
  this->program.Set("fieldTexture", field.Texture());
  const glm::dvec3 size(field.Size());
  if (isOfCells)
  {
    this->program.Set("cellCount", size);
    this->program.Set("cellCountInverse", 1.0 / size);
  }
  else
  {
    this->program.Set("brickCount", size);
    this->program.Set("brickCountInverse", 1.0 / size);
    this->program.Set("cellsPerBrick", double(BrickRanges::CellsPerSide));
  }
  if (this->frame.settings.acceleration == Acceleration::OpticalField &&
    IsExtreme(this->frame.settings.blend))
  {
    const TexelMapping& mapping = this->resources.Blocks().Texels().mapping;
    const ExtremeSteps steps = this->resources.ExtremeStepsOf(this->frame.settings.blend);
    this->program.Set("sense", steps.sense);
    this->program.Set("scalarFromField",
      glm::dvec2(65535.0 * steps.valuePerStep / mapping.scale,
        (steps.firstValue - mapping.offset) / mapping.scale));
  }
}

void VolumeUniforms::SetClassify()
{
  if (this->frame.settings.functionOf != FunctionOf::Value)
  {
    this->SetTwoValues();
    return;
  }
  if (this->frame.settings.mask == Mask::Labels)
  {
    this->resources.OpticalTables().Texture()->Activate();
    this->program.Set("opticalTable", this->resources.OpticalTables().Texture());
    return;
  }
  if (this->frame.settings.components != Components::One)
  {
    this->SetComponentTables();
    return;
  }
  // Texel to scalar to table index, as one scale and bias.
  const OpticalTable& table = this->resources.OpticalTables().Table();
  const double last = double(table.entries.size() - 1);
  const double extent = table.lastValue - table.firstValue;
  const double indexPerScalar = extent > 0.0 ? last / extent : 0.0;
  const TexelMapping& mapping = this->resources.Blocks().Texels().mapping;
  this->resources.OpticalTables().Texture()->Activate();
  this->program.Set("opticalTable", this->resources.OpticalTables().Texture());
  this->program.Set("tableFromScalar",
    glm::dvec2(
      mapping.scale * indexPerScalar, (mapping.offset - table.firstValue) * indexPerScalar));
  this->program.Set("lastTableIndex", last);
}

void VolumeUniforms::SetPreIntegrated()
{
  const OpticalTable& table = this->resources.OpticalTables().Table();
  const double extent = table.lastValue - table.firstValue;
  const double placePerValue = extent > 0.0 ? 1.0 / extent : 0.0;
  const TexelMapping& mapping = this->resources.Blocks().Texels().mapping;
  this->resources.PreIntegrated().Texture()->Activate();
  this->program.Set("preIntegratedTable", this->resources.PreIntegrated().Texture());
  this->program.Set("tableSize", double(this->resources.PreIntegrated().Size()));
  this->program.Set("placeFromScalar",
    glm::dvec2(mapping.scale * placePerValue, (mapping.offset - table.firstValue) * placePerValue));
  this->program.Set("opticalBelow", glm::dvec4(table.entries.front()));
  this->program.Set("opticalAbove", glm::dvec4(table.entries.back()));
}

void VolumeUniforms::SetTwoValues()
{
  const auto placeOf = [](const ScalarTexels& texels)
  {
    const double range = texels.largestScalar - texels.smallestScalar;
    const double perValue = range > 0.0 ? 1.0 / range : 0.0;
    return glm::dvec2(
      texels.mapping.scale * perValue, (texels.mapping.offset - texels.smallestScalar) * perValue);
  };
  const std::vector<ScalarTexels>& texels = this->resources.Blocks().TexelsOfChannels();
  this->resources.TwoValues().Texture()->Activate();
  this->program.Set("twoValueTable", this->resources.TwoValues().Texture());
  this->program.Set("twoValueTableSize", glm::dvec2(this->resources.TwoValuesSize()));
  this->program.Set("tableUnitDistanceMm", this->frame.property->GetScalarOpacityUnitDistance());
  this->program.Set("placeFromScalar", placeOf(texels.front()));
  if (this->frame.settings.functionOf == FunctionOf::TwoValues)
  {
    this->program.Set("placeFromSecond", placeOf(texels.back()));
    return;
  }
  this->program.Set("spacingFactors", this->frame.geometry.gradientFactors);
  this->program.Set(
    "placePerGradient", texels.front().mapping.scale / LargestGradient(texels.front()));
}

void VolumeUniforms::SetGaps(const DrawnBlock& drawn)
{
  const AccelerationField& gaps = drawn.block->gaps;
  const glm::dvec3 cells(gaps.Size());
  gaps.Texture()->Activate();
  this->program.Set("gapTexture", gaps.Texture());
  this->program.Set("gapCellCount", cells);
  this->program.Set("gapCellCountInverse", 1.0 / cells);
  this->program.Set("gapShift", this->frame.blanking.IsOfVoxels() ? 0.5 : 0.0);
  this->program.Set("gapVoxelCount", glm::dvec3(drawn.voxels.count));
  if (FillsGaps(this->frame.settings))
  {
    this->program.Set("gapOptical", this->frame.gapOptical);
  }
}

void VolumeUniforms::SetMask()
{
  const glm::dvec3 size(this->resources.Mask().Size());
  this->resources.Mask().Texture()->Activate();
  this->program.Set("maskTexture", this->resources.Mask().Texture());
  this->program.Set("maskVoxelCount", size);
  this->program.Set("maskVoxelsPerVoxel", size / glm::dvec3(this->frame.geometry.dimensions));
  if (this->frame.settings.mask == Mask::Labels)
  {
    this->program.Set("labelPart", this->frame.labelPart);
    this->program.Set("labelUnitDistanceMm", this->frame.property->GetScalarOpacityUnitDistance());
  }
}

}
