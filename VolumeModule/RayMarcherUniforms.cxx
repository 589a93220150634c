// The uniforms of each slot, when all resources of a frame are there.

#include "RayMarcher.h"

#include "Core/ShaderRecipe.h"
#include "JoinedFrame.h"

#include "vtkRenderer.h"
#include "vtkVolumeProperty.h"

#include <glm/gtc/matrix_access.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>

namespace varimarch
{

// As many as a ray along the diagonal takes at the sample distance, and as many as the faces of
// cells it can pass.
int MostSegmentsOf(const Frame& frame)
{
  const double steps = std::ceil(LongestRayMm(frame) / frame.sampleDistanceMm);
  int most = int(steps);
  const auto add = [&](const Frame& one)
  { most += one.geometry.dimensions.x + one.geometry.dimensions.y + one.geometry.dimensions.z; };
  add(frame);
  std::for_each(frame.others.begin(), frame.others.end(), add);
  return most;
}

void RayMarcher::SetRayUniforms(
  const Frame& frame, const DrawnBlock& drawn, const glm::dmat4& clipFromGrid)
{
  // The same rays for every block, to the last bit: none then has a gap where two blocks meet.
  const PixelRays rays = ComputePixelRays(clipFromGrid, this->drawnBox);
  const Viewport& viewport = frame.viewport;

  this->program.Set("clipFromGrid", clipFromGrid);
  this->program.Set(
    "viewportOriginPixels", glm::dvec2(viewport.left, viewport.bottom) - frame.rayOffsetPixels);
  this->program.Set("viewportPixelsInverse", 1.0 / glm::dvec2(viewport.width, viewport.height));
  this->program.Set("startGrid", rays.startGrid);
  this->program.Set("directionGrid", rays.directionGrid);
  this->program.Set("nearPlaneGrid", rays.nearPlaneGrid);
  this->program.Set("farPlaneGrid", rays.farPlaneGrid);
  this->program.Set("boxLowerGrid", drawn.boxGrid.lower);
  this->program.Set("boxUpperGrid", drawn.boxGrid.upper);
  this->program.Set("mostSegments", MostSegmentsOf(frame));
  this->SetPlaceUniforms(frame, drawn);
}

void RayMarcher::SetPlaceUniforms(const Frame& frame, const DrawnBlock& drawn)
{
  this->program.Set("worldFromGrid", frame.geometry.WorldFromGridDirection());
  this->program.Set("firstVoxelGrid", glm::dvec3(drawn.voxels.first));
  this->program.Set("voxelCountInverse", 1.0 / glm::dvec3(drawn.voxels.count));
}

void RayMarcher::SetResumeUniforms(const Frame& frame, const DrawnBlock& drawn)
{
  vtkTextureObject* const gathered = frame.settings.pass == RayPass::Block
    ? this->accumulation.Drawn()
    : this->accumulation.Finished();
  gathered->Activate();
  this->program.Set("gatheredTexture", gathered);
  this->program.Set("sharedUpperGrid", drawn.sharedUpperGrid);
}

void RayMarcher::SetGapUniforms(const Frame& frame, const DrawnBlock& drawn)
{
  const AccelerationField& gaps = drawn.block->gaps;
  const glm::dvec3 cells(gaps.Size());
  gaps.Texture()->Activate();
  this->program.Set("gapTexture", gaps.Texture());
  this->program.Set("gapCellCount", cells);
  this->program.Set("gapCellCountInverse", 1.0 / cells);
  this->program.Set("gapShift", frame.blanking.IsOfVoxels() ? 0.5 : 0.0);
  this->program.Set("gapVoxelCount", glm::dvec3(drawn.voxels.count));
  if (FillsGaps(frame.settings))
  {
    this->program.Set("gapOptical", frame.gapOptical);
  }
}

void RayMarcher::SetCutUniforms(const Frame& frame)
{
  if (frame.settings.clipping)
  {
    this->clippingPlanes.Texture()->Activate();
    this->program.Set("clippingPlanes", this->clippingPlanes.Texture());
    this->program.Set("clippingPlaneCount", int(frame.cuts.planesGrid.size()));
    this->program.Set("clippedScalar",
      this->blocks.Texels().mapping.LimitedTexelOf(frame.property->GetClippedVoxelIntensity()));
  }
  if (frame.settings.cropping && frame.settings.pass != RayPass::Picture)
  {
    this->program.Set("croppingPlanes", frame.cuts.regions->planesGrid);
    this->program.Set("croppingRegions", frame.cuts.regions->drawn);
  }
}

void RayMarcher::SetDepthUniforms(const Frame& frame, const glm::dmat4& clipFromGrid)
{
  const glm::dvec2 depthPixels(
    this->depth.Texture()->GetWidth(), this->depth.Texture()->GetHeight());
  this->program.Set(
    "depthPixelsPerPixel", depthPixels / glm::dvec2(frame.viewport.width, frame.viewport.height));
  this->depth.Texture()->Activate();
  this->program.Set("depthTexture", this->depth.Texture());
  this->program.Set("clipDepthRow", glm::row(clipFromGrid, 2));
  this->program.Set("clipWeightRow", glm::row(clipFromGrid, 3));
}

void RayMarcher::SetNoiseUniforms()
{
  this->picture.noise.Texture()->Activate();
  this->program.Set("noiseTexture", this->picture.noise.Texture());
  this->program.Set("noisePixelsMask", glm::ivec2(BlueNoiseTexture::Pixels - 1));
}

// What a ray has found is the extreme of a brick even where rounding has made it less.
ExtremeSteps RayMarcher::ExtremeStepsOf(Blend blend) const
{
  constexpr double rounding = 1.0 / 64.0; // of a step
  const double sense = blend == Blend::MaximumIntensity ? 1.0 : -1.0;
  const BrickRanges& ranges = this->field.Ranges();
  return { sense, ranges.FirstValue() - sense * rounding * ranges.ValuePerStep(),
    ranges.ValuePerStep() };
}

void RayMarcher::SetStepUniforms(const Frame& frame, const VolumeBlock& block)
{
  this->program.Set("stepMm", frame.sampleDistanceMm);
  if (frame.settings.jitter)
  {
    this->SetNoiseUniforms();
  }
  const bool isOfCells = frame.settings.acceleration == Acceleration::ScalarField;
  const bool isOfBricks =
    frame.settings.acceleration == Acceleration::OpticalField && frame.settings.skipsBricks;
  if (!isOfCells && !isOfBricks)
  {
    return;
  }
  const AccelerationField& field = isOfCells ? block.scalarField : this->field;
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
  if (frame.settings.acceleration == Acceleration::OpticalField && IsExtreme(frame.settings.blend))
  {
    const TexelMapping& mapping = this->blocks.Texels().mapping;
    const ExtremeSteps steps = this->ExtremeStepsOf(frame.settings.blend);
    this->program.Set("sense", steps.sense);
    this->program.Set("scalarFromField",
      glm::dvec2(65535.0 * steps.valuePerStep / mapping.scale,
        (steps.firstValue - mapping.offset) / mapping.scale));
  }
}

void RayMarcher::SetClassifyUniforms(const Frame& frame)
{
  if (frame.settings.functionOf != FunctionOf::Value)
  {
    this->SetTwoValueUniforms(frame);
    return;
  }
  if (frame.settings.mask == Mask::Labels)
  {
    this->opticalTable.Texture()->Activate();
    this->program.Set("opticalTable", this->opticalTable.Texture());
    return;
  }
  if (frame.settings.components != Components::One)
  {
    this->SetComponentTableUniforms();
    return;
  }
  // Texel to scalar to table index, as one scale and bias.
  const OpticalTable& table = this->opticalTable.Table();
  const double last = double(table.entries.size() - 1);
  const double extent = table.lastValue - table.firstValue;
  const double indexPerScalar = extent > 0.0 ? last / extent : 0.0;
  const TexelMapping& mapping = this->blocks.Texels().mapping;
  this->opticalTable.Texture()->Activate();
  this->program.Set("opticalTable", this->opticalTable.Texture());
  this->program.Set("tableFromScalar",
    glm::dvec2(
      mapping.scale * indexPerScalar, (mapping.offset - table.firstValue) * indexPerScalar));
  this->program.Set("lastTableIndex", last);
}

void RayMarcher::SetPreIntegratedUniforms()
{
  const OpticalTable& table = this->opticalTable.Table();
  const double extent = table.lastValue - table.firstValue;
  const double placePerValue = extent > 0.0 ? 1.0 / extent : 0.0;
  const TexelMapping& mapping = this->blocks.Texels().mapping;
  this->preIntegratedTable.Texture()->Activate();
  this->program.Set("preIntegratedTable", this->preIntegratedTable.Texture());
  this->program.Set("tableSize", double(this->preIntegratedTable.Size()));
  this->program.Set("placeFromScalar",
    glm::dvec2(mapping.scale * placePerValue, (mapping.offset - table.firstValue) * placePerValue));
  this->program.Set("opticalBelow", glm::dvec4(table.entries.front()));
  this->program.Set("opticalAbove", glm::dvec4(table.entries.back()));
}

void RayMarcher::SetBlendUniforms(const Frame& frame)
{
  if (frame.settings.windowLevel)
  {
    this->program.Set("windowScaleBias", frame.windowScaleBias);
  }
  if (frame.settings.blend == Blend::Composite || IsOfSurfaces(frame.settings.blend))
  {
    this->program.Set("earlyTerminationTransmittance", frame.earlyTerminationTransmittance);
    return;
  }
  if (frame.settings.components != Components::One)
  {
    this->SetComponentProjectionUniforms(frame);
    return;
  }
  this->SetProjectionUniforms(frame);
}

void RayMarcher::SetProjectionUniforms(const Frame& frame)
{
  const TexelMapping& mapping = this->blocks.Texels().mapping;
  const ScalarTexels& texels = this->blocks.Texels();
  const bool isExtreme = IsExtreme(frame.settings.blend);
  const double smallest = mapping.TexelOf(isExtreme ? texels.smallestValue : texels.smallestScalar);
  const double largest = mapping.TexelOf(isExtreme ? texels.largestValue : texels.largestScalar);
  this->program.Set("smallestScalar", smallest);
  this->program.Set("opacityUnitDistanceMm", frame.property->GetScalarOpacityUnitDistance());
  switch (frame.settings.blend)
  {
    case Blend::AverageIntensity:
      this->program.Set("averagedScalars",
        glm::dvec2(mapping.LimitedTexelOf(frame.averagedRange[0]),
          mapping.LimitedTexelOf(frame.averagedRange[1])));
      [[fallthrough]];
    case Blend::Additive:
      this->program.Set("grayPerScalar", largest > smallest ? 1.0 / (largest - smallest) : 0.0);
      break;
    default:
      this->program.Set("largestScalar", largest);
  }
}

void RayMarcher::SetMarchUniforms(const Frame& frame, const DrawnBlock& drawn)
{
  const VolumeTexture& volume = drawn.block->volume;
  const int filter = frame.settings.nearest ? vtkTextureObject::Nearest : vtkTextureObject::Linear;
  volume.Texture()->SetMinificationFilter(filter);
  volume.Texture()->SetMagnificationFilter(filter);
  volume.Texture()->Activate();
  this->program.Set("volumeTexture", volume.Texture());
  if (!IsSampled(frame.settings))
  {
    this->SetExactUniforms(frame, drawn);
  }
  if (frame.settings.cubic)
  {
    this->program.Set("splineVoxelCount", glm::dvec3(drawn.voxels.count));
  }
  if (frame.settings.uneven)
  {
    this->SetSpacingUniforms(frame);
  }
  this->SetStepUniforms(frame, *drawn.block);
  if (UsesPreIntegration(frame.settings))
  {
    this->SetPreIntegratedUniforms();
  }
  else
  {
    this->SetClassifyUniforms(frame);
  }
  if (MarchesMaterial(frame.settings))
  {
    this->SetMaterialUniforms(frame, drawn);
  }
  if (frame.settings.gaps)
  {
    this->SetGapUniforms(frame, drawn);
  }
  if (frame.settings.mask != Mask::None)
  {
    this->SetMaskUniforms(frame);
  }
}

void RayMarcher::SetUniforms(const Frame& frame, const DrawnBlock& drawn)
{
  const glm::dmat4 clipFromGrid = ClipFromWorld(frame.renderer) * frame.geometry.worldFromGrid;
  const RayPass pass = frame.settings.pass;
  if (pass == RayPass::Accumulated || pass == RayPass::Marched)
  {
    pass == RayPass::Accumulated ? this->SetMeanUniforms(frame, clipFromGrid)
                                 : this->SetMarchedUniforms(frame, clipFromGrid);
    return;
  }
  this->SetRayUniforms(frame, drawn, clipFromGrid);
  this->SetCutUniforms(frame);
  if (pass == RayPass::Block || pass == RayPass::Picture)
  {
    this->SetResumeUniforms(frame, drawn);
  }
  if (pass == RayPass::Upscaled || pass == RayPass::Averaged)
  {
    this->SetResampledUniforms(frame);
  }
  else
  {
    this->SetBlendUniforms(frame);
  }
  if (Marches(pass))
  {
    this->SetMarchUniforms(frame, drawn);
    this->SetUniformsOfOthers(frame);
    this->SetPassUniforms(frame, clipFromGrid);
    this->program.SetUniformsOf(frame.volume);
  }
  else if (pass == RayPass::Picture && IsProjection(frame.settings.blend))
  {
    this->SetClassifyUniforms(frame);
  }
  if (frame.settings.sceneGeometry)
  {
    this->SetDepthUniforms(frame, clipFromGrid);
  }
}

}
