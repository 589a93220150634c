#include "RayMarcher.h"

#include "Core/ShaderRecipe.h"
#include "Core/SplineCoefficients.h"
#include "JoinedFrame.h"
#include "PropertyTransferFunction.h"

#include "vtkDataArray.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <utility>

namespace varimarch
{

namespace
{

// The tolerance of the field when none is given, as a part of the range of the scalars.
constexpr double DefaultToleranceOfRange = 1.0 / 256.0;

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

void RayMarcher::Draw(Frame frame)
{
  this->EnterWindow(frame.window);
  this->BeginAccumulation(frame);
  this->UpdateVolume(frame);
  frame.marcher = this->MarchesPackets(frame) ? Marcher::Processor : Marcher::Device;
  if (frame.marcher == Marcher::Device)
  {
    this->packets.Release(frame.window);
  }
  frame.sampleDistanceMm = std::max(frame.sampleDistanceMm, ShortestSampleDistanceMm(frame));
  this->UpdateDepth(frame);
  this->UpdateNoise(frame);
  this->UpdateCuts(frame);
  this->UpdateOthers(frame);
  this->UpdateResources(frame);
  this->drawnBox = this->BoxOfAll(frame);
  this->UpdateTolerance(frame);

  if (this->tolerance)
  {
    frame.settings.integration = this->tolerance->integration;
    // Others than those who found the steps may draw by them: shaders, that count readings.
    frame.sampleDistanceMm =
      std::max(this->SampleDistanceInView(), ShortestSampleDistanceMm(frame));
  }
  this->usedSampleDistanceMm = frame.sampleDistanceMm;
  this->UpdatePreIntegratedTable(frame);
  this->DrawPicture(frame);
}

// Those that a volume has for itself, be it one of several.
void RayMarcher::UpdateResources(Frame& frame)
{
  this->UpdateOpticalTable(frame);
  this->UpdateGradientOpacity(frame);
  this->UpdateMask(frame);
  this->UpdateField(frame);
  frame.settings.skipsBricks = this->field.SkipsAny();
  this->UpdateLights(frame);
  this->UpdateIsosurfaces(frame);
  this->UpdateSpacing(frame);
  this->UpdateBlocks(frame);
}

void RayMarcher::EnterWindow(vtkOpenGLRenderWindow* window)
{
  if (this->window && this->window != window)
  {
    this->Release(this->window);
  }
  this->window = window;
}

void RayMarcher::UpdateVolume(const Frame& frame)
{
  this->blocks.SetBlanking(frame.blanking);
  const bool isCubic = frame.settings.cubic;
  if (this->volumeSource == frame.channels && this->volumeTime == frame.scalarsTime &&
    this->volumeIsCubic == isCubic)
  {
    return;
  }
  this->volumeSource.clear();
  const glm::ivec3 dimensions = frame.geometry.dimensions;
  this->spline = isCubic ? SplineVolume(frame.channels, dimensions) : SplineVolume();
  this->blocks.SetVoxels(isCubic
      ? VoxelValues{ this->spline.Channels(), dimensions, this->spline.Texels(frame.channels),
          SplineReachVoxels }
      : VoxelValues{ frame.channels, dimensions, ScalarTexelsOf(frame.channels) });
  this->volumeSource = frame.channels;
  this->volumeTime = frame.scalarsTime;
  this->volumeIsCubic = isCubic;
  this->tableSource = nullptr; // a table covers the range of the scalars
  this->voxelsAreFinite.reset();
  ++this->builds.volumeTexture;
}

void RayMarcher::UpdateOpticalTable(const Frame& frame)
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

void RayMarcher::UpdatePreIntegratedTable(const Frame& frame)
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

void RayMarcher::UpdateField(const Frame& frame)
{
  if (frame.settings.acceleration != Acceleration::ScalarField)
  {
    this->blocks.SetScalarField(frame.window, {});
  }
  switch (frame.settings.acceleration)
  {
    case Acceleration::Off:
      this->field.Release(frame.window);
      this->fieldSource.reset();
      this->rangesOfVolume = 0;
      break;
    case Acceleration::ScalarField:
      this->UpdateScalarField(frame);
      break;
    case Acceleration::OpticalField:
      if (IsExtreme(frame.settings.blend))
      {
        this->UpdateExtremes(frame);
      }
      else if (frame.settings.blend == Blend::Isosurface)
      {
        this->UpdateIsosurfaceField(frame);
      }
      else
      {
        this->UpdateOpticalField(frame);
      }
      break;
  }
}

void RayMarcher::UpdateScalarField(const Frame& frame)
{
  const ScalarTexels& texels = this->blocks.Texels();
  const double range = texels.largestScalar - texels.smallestScalar;
  const double tolerance =
    frame.variationTolerance >= 0.0 ? frame.variationTolerance : DefaultToleranceOfRange * range;
  const FieldSource source{ Acceleration::ScalarField, this->builds.volumeTexture, 0, tolerance };
  if (this->fieldSource == source)
  {
    return;
  }
  this->field.Release(frame.window);
  this->rangesOfVolume = 0;
  this->blocks.SetScalarField(frame.window, tolerance);
  this->fieldSource = source;
  ++this->builds.field;
}

// Whether there is not yet this field for the rays of a frame; what it is made of is then ready.
// One for other rays counts as no other: what it shows is the same.
bool RayMarcher::BeginsField(const Frame& frame, FieldSource& source)
{
  const glm::dmat4 clipFromGrid = ClipFromWorld(frame.renderer) * frame.geometry.worldFromGrid;
  const PixelRays rays = ComputePixelRays(clipFromGrid, frame.geometry.boxGrid);
  source.towards = this->fieldDirections.Next(DirectionsOf(rays));
  if (this->fieldSource == source)
  {
    return false;
  }
  this->builds.field += this->fieldSource && this->fieldSource->ShowsSame(source) ? 0 : 1;
  this->fieldSource.reset();
  this->UpdateRanges();
  return true;
}

void RayMarcher::UpdateOpticalField(const Frame& frame)
{
  const double longestRayMm = frame.geometry.DiagonalMm();
  const OpticalTolerance tolerance =
    MarchesMaterial(frame.settings) || IsProjection(frame.settings.blend)
    ? OpticalTolerance::Nothing(longestRayMm)
    : OpticalTolerance::ForError(frame.fieldError, longestRayMm);
  FieldSource source{ Acceleration::OpticalField, this->builds.volumeTexture,
    this->builds.opticalTable, tolerance.color / tolerance.longestRayMm, 0.0, frame.marcher };
  if (!this->BeginsField(frame, source))
  {
    return;
  }
  std::vector<ChannelTable> tables;
  for (std::size_t i = 0; i < this->materialTables.size(); ++i)
  {
    if (this->materialTables[i].decidesOnOpacity)
    {
      tables.push_back({ this->materialTables[i].channel, &this->opticalTable.Tables()[i] });
    }
  }
  this->field.BuildOpticalField(frame.window, tables, tolerance, source.towards, frame.marcher);
  this->fieldSource = source;
}

void RayMarcher::UpdateExtremes(const Frame& frame)
{
  const bool largest = frame.settings.blend == Blend::MaximumIntensity;
  const FieldSource source{ Acceleration::OpticalField, this->builds.volumeTexture,
    this->builds.opticalTable, frame.fieldError, largest ? 1.0 : -1.0, frame.marcher };
  if (this->fieldSource == source)
  {
    return;
  }
  this->fieldSource.reset();
  this->UpdateRanges();
  const ExtremeLook look{ this->opticalTable.Table(),
    frame.property->GetScalarOpacityUnitDistance(), frame.fieldError };
  this->field.BuildExtremes(frame.window, look, largest, frame.marcher);
  this->fieldSource = source;
  ++this->builds.field;
}

void RayMarcher::UpdateRanges()
{
  if (this->rangesOfVolume != this->builds.volumeTexture)
  {
    this->field.BuildRanges(this->blocks.Values());
    this->rangesOfVolume = this->builds.volumeTexture;
    ++this->builds.brickRanges;
  }
}

void RayMarcher::UpdateDepth(const Frame& frame)
{
  if (!frame.settings.sceneGeometry)
  {
    this->depth.Release(frame.window);
    return;
  }
  this->depth.Capture(frame.window, frame.viewport.left, frame.viewport.bottom,
    frame.viewport.width, frame.viewport.height);
}

void RayMarcher::UpdateNoise(const Frame& frame)
{
  if (!frame.settings.jitter)
  {
    this->picture.noise.Release(frame.window);
    return;
  }
  this->picture.noise.MakeTile();
  frame.marcher == Marcher::Processor ? this->picture.noise.ReleaseTexture(frame.window)
                                      : this->picture.noise.Upload(frame.window);
}

void RayMarcher::UpdateCuts(const Frame& frame)
{
  if (!frame.settings.clipping || frame.marcher == Marcher::Processor)
  {
    this->clippingPlanes.Release(frame.window);
    return;
  }
  const std::vector<glm::dvec4>& planes = frame.cuts.planesGrid;
  this->clippingPlanes.Upload(frame.window, std::vector<glm::vec4>(planes.begin(), planes.end()));
}

void RayMarcher::UpdateProgram(const Frame& frame)
{
  if (this->program.Use(frame.window, frame.settings, frame.userCode))
  {
    ++this->builds.shader;
  }
  if (Marches(frame.settings.pass))
  {
    this->shaderParts = this->program.Parts();
  }
}

std::size_t RayMarcher::GraphicsMemoryBytes() const
{
  return this->clippingPlanes.Bytes() + this->isosurfaces.Bytes() + this->spacing.Bytes() +
    this->blocks.Bytes() + this->field.Bytes() + this->opticalTable.Bytes() +
    this->preIntegratedTable.Bytes() + this->depth.Bytes() + this->lights.Bytes() +
    this->gradientOpacity.Bytes() + this->twoValues.Bytes() + this->mask.Bytes() +
    this->probe.Bytes() + this->accumulation.Bytes() + this->picture.Bytes() +
    this->packets.Bytes() + this->BytesOfOthers();
}

double RayMarcher::FieldBuildSeconds() const
{
  const bool isOfCells =
    this->fieldSource && this->fieldSource->acceleration == Acceleration::ScalarField;
  return isOfCells ? this->blocks.FieldBuildSeconds() : this->field.BuildSeconds();
}

void RayMarcher::Release(vtkWindow* window)
{
  this->ReleaseOthers(window, 0);
  this->blocks.Release(window);
  this->accumulation.Release(window);
  this->picture.Release(window);
  this->field.Release(window);
  this->opticalTable.Release(window);
  this->preIntegratedTable.Release(window);
  this->depth.Release(window);
  this->lights.Release(window);
  this->gradientOpacity.Release(window);
  this->twoValues.Release(window);
  this->mask.Release(window);
  this->gradientOpacitySource.clear();
  this->clippingPlanes.Release(window);
  this->isosurfaces.Release(window);
  this->spacing.Release(window);
  this->spacingBins.clear();
  this->packets.Release(window);
  this->boxGeometry.Release();
  this->program.Forget();
  this->volumeSource.clear();
  this->spline = SplineVolume();
  this->visibleOfField = -1;
  this->fieldSource.reset();
  this->rangesOfVolume = 0;
  this->preIntegratedOfTable = 0;
  this->probe.Release(window);
  this->tolerance.reset();
  this->window = nullptr;
}

}
