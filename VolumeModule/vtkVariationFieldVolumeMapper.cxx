#include "vtkVariationFieldVolumeMapper.h"

#include "Frame/FrameBuilder.h"
#include "Frame/MissingFeatures.h"
#include "Frame/NumberCheck.h"
#include "Frame/RendererVolumes.h"
#include "Frame/RequestedPass.h"
#include "Frame/ShadowCasters.h"
#include "Frame/VoxelsOnDisk.h"
#include "March/Device/GraphicsDriver.h"
#include "March/FrameMarcher.h"
#include "March/MapperInternals.h"
#include "March/PassMarch.h"
#include "Tolerance/AccuracyNotes.h"

#include "vtkCommand.h"
#include "vtkDataSet.h"
#include "vtkImageData.h"
#include "vtkIndent.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleKey.h"
#include "vtkInformationIntegerKey.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLError.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkStringArray.h"
#include "vtkTimerLog.h"
#include "vtkVolume.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <optional>
#include <stdexcept>
#include <utility>

namespace
{

double PixelCount(const varimarch::Frame& frame)
{
  return double(frame.view.viewport.width) * frame.view.viewport.height;
}

}

std::optional<varimarch::PictureQuality> vtkVariationFieldVolumeMapper::Internals::QualityOf(
  vtkVariationFieldVolumeMapper* mapper, vtkVolume* volume, const varimarch::Frame& frame) const
{
  return varimarch::IsInteractive(mapper, volume, frame)
    ? std::optional<varimarch::PictureQuality>(this->Quality.Now(PixelCount(frame)))
    : std::nullopt;
}

// Draws at the quality that the allocated time permits, or at full quality if nobody interacts.
void vtkVariationFieldVolumeMapper::Internals::DrawInTime(
  vtkVariationFieldVolumeMapper* mapper, vtkVolume* volume, const varimarch::Frame& frame)
{
  varimarch::RayMarcher& marcher = *this->Last;
  const double castSeconds = std::exchange(this->CastSeconds, 0.0);
  if (!varimarch::IsInteractive(mapper, volume, frame))
  {
    marcher.Draw(frame);
    return;
  }
  const varimarch::PictureQuality quality =
    this->Quality.Next(volume->GetAllocatedRenderTime(), PixelCount(frame));
  const int builds = marcher.ResourceBuilds();
  frame.view.window->WaitForCompletion();
  vtkNew<vtkTimerLog> timer;
  timer->StartTimer();
  marcher.Draw(frame, quality);
  frame.view.window->WaitForCompletion();
  timer->StopTimer();
  const bool hasBuilt = marcher.ResourceBuilds() != builds;
  // Resources that every image builds, as while times are played, are a part of its time.
  if (!hasBuilt || this->LastHasBuilt)
  {
    this->Quality.Took(castSeconds + timer->GetElapsedTime());
  }
  this->LastHasBuilt = hasBuilt;
}

vtkStandardNewMacro(vtkVariationFieldVolumeMapper);
vtkInformationKeyMacro(vtkVariationFieldVolumeMapper, LIGHT_SOFTNESS, Double);
vtkInformationKeyMacro(vtkVariationFieldVolumeMapper, CASTS_SHADOWS, Integer);

vtkVariationFieldVolumeMapper::vtkVariationFieldVolumeMapper()
  : Private(std::make_unique<Internals>())
{
  this->SetNumberOfInputPorts(10); // as many as vtkGPUVolumeRayCastMapper has
  const auto tell = [this](double part) { this->UpdateProgress(part); };
  this->Private->Marcher.SetProgress(tell);
  this->Private->Levels.Marcher().SetProgress(tell);
}

vtkVariationFieldVolumeMapper::~vtkVariationFieldVolumeMapper()
{
  this->SetTransfer2DYAxisArray(nullptr);
}

void vtkVariationFieldVolumeMapper::SetMaskInput(vtkImageData* mask)
{
  if (this->MaskInput != mask)
  {
    this->MaskInput = mask;
    this->Modified();
  }
}

vtkImageData* vtkVariationFieldVolumeMapper::GetMaskInput()
{
  return this->MaskInput;
}

// Draws one volume, with the events, the timing and the error report of a mapper.
void vtkVariationFieldVolumeMapper::Internals::Draw(
  vtkVariationFieldVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume)
{
  vtkNew<vtkTimerLog> timer;
  timer->StartTimer();
  mapper->InvokeEvent(vtkCommand::VolumeMapperRenderStartEvent, nullptr);
  try
  {
    mapper->DrawFrame(renderer, volume);
    mapper->Private->ReportedError.clear();
  }
  catch (const varimarch::DrawingStopped&)
  {
    // Whoever stopped it knows.
  }
  catch (const std::bad_alloc&)
  {
    mapper->ReportOnce("Not enough memory to draw this volume; close other programs, or draw a "
                       "smaller volume or image");
  }
  catch (const varimarch::GraphicsReset& reset)
  {
    mapper->ReportOnce(reset.what());
    mapper->InvokeEvent(varimarch::GraphicsResetEvent, nullptr);
  }
  catch (const std::exception& problem)
  {
    mapper->ReportOnce(problem.what());
  }
  mapper->InvokeEvent(vtkCommand::VolumeMapperRenderEndEvent, nullptr);
  timer->StopTimer();
  mapper->TimeToDraw = timer->GetElapsedTime();
}

void vtkVariationFieldVolumeMapper::Render(vtkRenderer* renderer, vtkVolume* volume)
{
  const varimarch::RayPass pass = varimarch::PassOfVolume(this, renderer, volume).kind;
  const bool isPart = varimarch::DrawingMapper(volume) != this;
  if (!isPart && !this->RenderToImage && pass == varimarch::RayPass::Whole)
  {
    Internals::DrawInOrder(this, renderer, volume);
    return;
  }
  if (!isPart)
  {
    Internals::CastBeforeFirst(this, renderer, pass);
  }
  Internals::Draw(this, renderer, volume);
}

double* vtkVariationFieldVolumeMapper::GetBounds()
{
  double* const bounds = this->Superclass::GetBounds();
  const auto isFinite = [](double place) { return std::isfinite(place); };
  return std::all_of(bounds, bounds + 6, isFinite) ? bounds : nullptr;
}

void vtkVariationFieldVolumeMapper::LockSampleDistance()
{
  auto* image = vtkImageData::SafeDownCast(this->GetInput());
  if (image && this->LockSampleDistanceToInputSpacing)
  {
    this->SampleDistance =
      this->SpacingAdjustedSampleDistance(image->GetSpacing(), image->GetExtent());
  }
}

void vtkVariationFieldVolumeMapper::DrawFrame(vtkRenderer* renderer, vtkVolume* volume)
{
  this->LockSampleDistance();
  varimarch::SelectorScope selected(renderer->GetSelector());
  const std::optional<varimarch::Frame> frame = varimarch::BuildFrame(this, renderer, volume);
  if (frame)
  {
    const varimarch::VoxelsOnDisk onDisk(*frame, this->MaximumHostMemory);
    const auto instead = this->Private->Levels.FrameInstead(
      this, volume, *frame, this->Private->Last->AccumulatedImages() > 0);
    const bool isOfLevel = instead && instead->coarser.empty();
    if (frame->settings.casters)
    {
      varimarch::KeepShadowsOutOfView(renderer);
    }
    this->Private->Last = isOfLevel ? &this->Private->Levels.Marcher() : &this->Private->Marcher;
    frame->view.window->MakeCurrent();
    try
    {
      this->Private->DrawInTime(this, volume, instead ? *instead : *frame);
    }
    catch (const std::exception&)
    {
      // A lost context fails in many ways.
      varimarch::CheckForGraphicsReset();
      throw;
    }
    varimarch::CheckForGraphicsReset();
    selected.ReportCounts(this->GetDataSetInput());
    vtkOpenGLCheckErrorMacro("OpenGL error after drawing");
    this->WarnOnce(varimarch::Joined(frame->replacedNumbers), this->Private->ReportedNumbers);
    this->WarnOnce(varimarch::MissingFeatures(this, volume) +
        varimarch::AccuracyWarnings(this, *this->Private->Last),
      this->Private->ReportedWarning);
    onDisk.Check();
  }
}

void vtkVariationFieldVolumeMapper::ReportOnce(const std::string& problem)
{
  if (this->Private->ReportedError != problem)
  {
    this->Private->ReportedError = problem;
    vtkErrorMacro(<< problem << ".");
  }
}

void vtkVariationFieldVolumeMapper::WarnOnce(const std::string& warning, std::string& reported)
{
  if (reported != warning)
  {
    reported = warning;
    if (!warning.empty())
    {
      vtkWarningMacro(<< warning);
    }
  }
}

double vtkVariationFieldVolumeMapper::GetUsedSampleDistance()
{
  return this->Private->Last->UsedSampleDistanceMm();
}

double vtkVariationFieldVolumeMapper::GetDrawnPart()
{
  const double part = this->Private->Last->DrawnPart(this->MaximumAccumulatedPictures);
  constexpr double NotAll = 0.99;
  return this->Private->Levels.MayBeRefined() ? std::min(part, NotAll) : part;
}

int vtkVariationFieldVolumeMapper::GetAccumulatedPictures()
{
  return this->Private->Last->AccumulatedImages();
}

double vtkVariationFieldVolumeMapper::GetUsedImageSampleDistance()
{
  return this->Private->Last->UsedImageSampleDistance();
}

void vtkVariationFieldVolumeMapper::GetColorImage(vtkImageData* image)
{
  const varimarch::Viewport& pixels = this->Private->Last->ImagePixels();
  if (pixels.width > 0)
  {
    varimarch::FillColorImage(
      this->Private->Last->ColorImage(), pixels.width, pixels.height, image);
  }
}

void vtkVariationFieldVolumeMapper::GetDepthImage(vtkImageData* image)
{
  const varimarch::Viewport& pixels = this->Private->Last->ImagePixels();
  if (pixels.width > 0)
  {
    varimarch::FillDepthImage(this->Private->Last->DepthImage(), pixels.width, pixels.height,
      this->DepthImageScalarType, image);
  }
}

double vtkVariationFieldVolumeMapper::GetEstimatedError()
{
  const auto& found = this->Private->Last->FoundStep();
  if (!found)
  {
    return 0.0;
  }
  return this->Private->Last->HasUnknownError() ? 1.0 : this->Private->Last->EstimatedError();
}

void vtkVariationFieldVolumeMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Private->Marcher.Release(window);
  this->Private->Levels.Release(window);
}

double vtkVariationFieldVolumeMapper::GetLevelErrorBound()
{
  return this->Private->Levels.ErrorBound();
}

int vtkVariationFieldVolumeMapper::GetUsedLevelOfDetail()
{
  return this->Private->Levels.Drawn().level;
}

vtkIdType vtkVariationFieldVolumeMapper::GetVisibleBlocks()
{
  return vtkIdType(this->Private->Levels.Drawn().visibleBlocks);
}

vtkIdType vtkVariationFieldVolumeMapper::GetRefinedBlocks()
{
  return vtkIdType(this->Private->Levels.Drawn().refinedBlocks);
}

bool vtkVariationFieldVolumeMapper::GetNextRefinementFits()
{
  return this->Private->Levels.Drawn().nextFits;
}

double vtkVariationFieldVolumeMapper::GetFieldBuildSeconds()
{
  return this->Private->Last->FieldBuildSeconds();
}

vtkIdType vtkVariationFieldVolumeMapper::GetGraphicsMemoryBytes()
{
  return vtkIdType(this->Private->Sum(&varimarch::RayMarcher::GraphicsMemoryBytes));
}

vtkIdType vtkVariationFieldVolumeMapper::GetLightMemoryBytes()
{
  return vtkIdType(this->Private->Sum(&varimarch::RayMarcher::LightBytes));
}

void vtkVariationFieldVolumeMapper::GetShaderParts(vtkStringArray* parts)
{
  parts->Initialize();
  for (const std::string& part : this->Private->Last->ShaderParts())
  {
    parts->InsertNextValue(part);
  }
}

int vtkVariationFieldVolumeMapper::GetVolumeTextureBuilds()
{
  return this->Private->Sum(
    [](const varimarch::RayMarcher& marcher) { return marcher.Builds().volumeTexture; });
}

int vtkVariationFieldVolumeMapper::GetBlockUploads()
{
  return this->Private->Sum(&varimarch::RayMarcher::BlockUploads);
}

int vtkVariationFieldVolumeMapper::GetBrickRangesBuilds()
{
  return this->Private->Sum(
    [](const varimarch::RayMarcher& marcher) { return marcher.Builds().brickRanges; });
}

int vtkVariationFieldVolumeMapper::GetFieldBuilds()
{
  return this->Private->Sum(
    [](const varimarch::RayMarcher& marcher) { return marcher.Builds().field; });
}

int vtkVariationFieldVolumeMapper::GetOpticalTableBuilds()
{
  return this->Private->Sum(
    [](const varimarch::RayMarcher& marcher) { return marcher.Builds().opticalTable; });
}

int vtkVariationFieldVolumeMapper::GetLightLatticeBuilds()
{
  return this->Private->Sum(&varimarch::RayMarcher::LightLatticeBuilds);
}

int vtkVariationFieldVolumeMapper::GetGeometryShadowBuilds()
{
  return this->Private->Sum(&varimarch::RayMarcher::GeometryShadowBuilds);
}

int vtkVariationFieldVolumeMapper::GetShaderBuilds()
{
  return this->Private->Sum(&varimarch::RayMarcher::ShaderBuilds);
}

int vtkVariationFieldVolumeMapper::GetToleranceSearches()
{
  return this->Private->Sum(&varimarch::RayMarcher::ToleranceSearches);
}

bool vtkVariationFieldVolumeMapper::GetErrorToleranceIsKept()
{
  const auto& found = this->Private->Last->FoundStep();
  const varimarch::DrawnLevel& drawn = this->Private->Levels.Drawn();
  if (drawn.level == CoarseLevel || this->Private->Levels.LastMayBeRefined())
  {
    return false;
  }
  return !found ||
    (this->Private->Last->KeepsTolerance() && !this->Private->Last->HasUnknownError());
}

int vtkVariationFieldVolumeMapper::FillInputPortInformation(int port, vtkInformation* information)
{
  information->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port > 0 ? 1 : 0);
  information->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  information->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkRectilinearGrid");
  return 1;
}

void vtkVariationFieldVolumeMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "AccelerationMode: " << this->AccelerationMode << "\n";
  os << indent << "ProcessorMarching: " << this->ProcessorMarching << "\n";
  os << indent << "IntegrationRule: " << this->IntegrationRule << "\n";
  os << indent << "VariationTolerance: " << this->VariationTolerance << "\n";
  os << indent << "SampleDistance: " << this->SampleDistance << "\n";
  os << indent << "SampleDistanceInVoxels: " << this->SampleDistanceInVoxels << "\n";
  os << indent << "MaximumNumberOfSteps: " << this->MaximumNumberOfSteps << "\n";
  os << indent << "FirstDistance: " << this->FirstDistance << "\n";
  os << indent << "AutoAdjustSampleDistances: " << this->AutoAdjustSampleDistances << "\n";
  os << indent << "LockSampleDistanceToInputSpacing: " << this->LockSampleDistanceToInputSpacing
     << "\n";
  os << indent << "EarlyTerminationTransmittance: " << this->EarlyTerminationTransmittance << "\n";
  os << indent << "ErrorTolerance: " << this->ErrorTolerance << "\n";
  os << indent << "CompositingOrder: " << this->CompositingOrder << "\n";
  os << indent << "CubicInterpolation: " << this->CubicInterpolation << "\n";
  os << indent << "StoredGradients: " << this->StoredGradients << "\n";
  os << indent << "UseJittering: " << this->UseJittering << "\n";
  os << indent << "ImageSampleDistance: " << this->ImageSampleDistance << "\n";
  os << indent << "MinimumImageSampleDistance: " << this->MinimumImageSampleDistance << "\n";
  os << indent << "MaximumImageSampleDistance: " << this->MaximumImageSampleDistance << "\n";
  os << indent << "MaximumAccumulatedPictures: " << this->MaximumAccumulatedPictures << "\n";
  os << indent << "LongestPartSeconds: " << this->LongestPartSeconds << "\n";
  os << indent << "NanColor: " << this->NanColor[0] << ", " << this->NanColor[1] << ", "
     << this->NanColor[2] << "\n";
  os << indent << "NanOpacity: " << this->NanOpacity << "\n";
  os << indent << "DampingGradient: " << this->DampingGradient << "\n";
  os << indent << "Shadows: " << (this->Shadows ? "On" : "Off") << "\n";
  os << indent << "ShadowStrength: " << this->ShadowStrength << "\n";
  os << indent << "VolumetricScatteringBlending: " << this->VolumetricScatteringBlending << "\n";
  os << indent << "GlobalIlluminationReach: " << this->GlobalIlluminationReach << "\n";
  os << indent << "ScatteringAnisotropy: " << this->ScatteringAnisotropy << "\n";
  os << indent << "AmbientOcclusion: " << this->AmbientOcclusion << "\n";
  os << indent << "AmbientOcclusionReach: " << this->AmbientOcclusionReach << "\n";
  os << indent << "MaskInput: " << this->MaskInput << "\n";
  os << indent << "MaskType: " << this->MaskType << "\n";
  os << indent << "MaskBlendFactor: " << this->MaskBlendFactor << "\n";
  os << indent << "LabelSurfaces: " << this->LabelSurfaces << "\n";
  os << indent << "Transfer2DYAxisArray: "
     << (this->Transfer2DYAxisArray ? this->Transfer2DYAxisArray : "none") << "\n";
  os << indent << "DrawFetchCounts: " << this->DrawFetchCounts << "\n";
  os << indent << "LevelOfDetail: " << this->LevelOfDetail << "\n";
  os << indent << "MaximumHostMemory: " << this->MaximumHostMemory << "\n";
  os << indent << "MaximumGraphicsMemory: " << this->MaximumGraphicsMemory << "\n";
  os << indent << "LightMemoryBytes: " << this->GetLightMemoryBytes() << "\n";
  os << indent << "UsedImageSampleDistance: " << this->GetUsedImageSampleDistance() << "\n";
  os << indent << "RenderToImage: " << this->RenderToImage << "\n";
  os << indent << "DepthImageScalarType: " << this->DepthImageScalarType << "\n";
  os << indent << "ClampDepthToBackface: " << this->ClampDepthToBackface << "\n";
  os << indent << "FinalColorWindow: " << this->FinalColorWindow << "\n";
  os << indent << "FinalColorLevel: " << this->FinalColorLevel << "\n";
  os << indent << "UsedSampleDistance: " << this->GetUsedSampleDistance() << "\n";
  os << indent << "EstimatedError: " << this->GetEstimatedError() << "\n";
}
