#include "vtkVariationFieldVolumeMapper.h"

#include "Core/InteractiveQuality.h"
#include "FrameOfMapper.h"
#include "ImagesOfPicture.h"
#include "PictureOfMapper.h"
#include "RayMarcher.h"

#include "vtkCommand.h"
#include "vtkDataSet.h"
#include "vtkHardwareSelector.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLError.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkStringArray.h"
#include "vtkTimerLog.h"
#include "vtkVolume.h"

#include <optional>
#include <sstream>
#include <stdexcept>

struct vtkVariationFieldVolumeMapper::Internals
{
  varimarch::RayMarcher Marcher;
  std::string ReportedError; ///< the one the user has already been told
  std::string ReportedWarning;
  varimarch::InteractiveQuality Quality;

  void DrawInTime(vtkVariationFieldVolumeMapper* mapper, vtkVolume* volume, varimarch::Frame frame);

  std::string Warnings(vtkVariationFieldVolumeMapper* mapper, vtkVolume* volume) const;
};

// What the last picture lacks of what was asked for; empty when it lacks nothing.
std::string vtkVariationFieldVolumeMapper::Internals::Warnings(
  vtkVariationFieldVolumeMapper* mapper, vtkVolume* volume) const
{
  std::string warnings = varimarch::MissingFeatures(mapper, volume);
  if (!mapper->GetAutoAdjustSampleDistances() &&
    this->Marcher.UsedSampleDistanceMm() > mapper->GetSampleDistance())
  {
    std::ostringstream text;
    text << "The sample distance " << mapper->GetSampleDistance()
         << " is too short for this volume: " << this->Marcher.UsedSampleDistanceMm()
         << " is used, 20000 samples along its diagonal. ";
    warnings += text.str();
  }
  if (this->Marcher.Tolerance() && !this->Marcher.Tolerance()->step.KeepsLimit())
  {
    std::ostringstream text;
    const varimarch::StepChoice& step = this->Marcher.Tolerance()->step;
    text << "The error tolerance " << mapper->ErrorTolerance
         << " cannot be kept: with a sample every " << step.sampleDistance
         << ", 99.9 % of the pixels are off by up to " << step.error << ". ";
    warnings += text.str();
  }
  return warnings;
}

namespace
{

// Somebody interacts where a picture is wanted in less than this.
constexpr double LongestInteractiveSeconds = 1.0;

// All but the search for steps, which every new view takes.
int BuildsOf(const varimarch::BuildCounts& builds)
{
  return builds.volumeTexture + builds.brickRanges + builds.field + builds.opticalTable +
    builds.shader;
}

// A selector counts a prop as selectable between these.
class PropOfSelector
{
public:
  explicit PropOfSelector(vtkHardwareSelector* selector)
    : selector(selector)
  {
    if (selector)
    {
      selector->BeginRenderProp();
    }
  }

  PropOfSelector(const PropOfSelector&) = delete;
  void operator=(const PropOfSelector&) = delete;

  ~PropOfSelector()
  {
    if (this->selector)
    {
      this->selector->EndRenderProp();
    }
  }

  // Numbers of more than 24 bits take further passes.
  void TellCounts(vtkDataSet* input)
  {
    if (this->selector && this->selector->GetCurrentPass() >= vtkHardwareSelector::POINT_ID_LOW24)
    {
      this->selector->UpdateMaximumPointId(input->GetNumberOfPoints());
      this->selector->UpdateMaximumCellId(input->GetNumberOfCells());
    }
  }

private:
  vtkHardwareSelector* selector;
};

}

// As coarsely as the allocated time asks for; in full where nobody waits.
void vtkVariationFieldVolumeMapper::Internals::DrawInTime(
  vtkVariationFieldVolumeMapper* mapper, vtkVolume* volume, varimarch::Frame frame)
{
  const double allocatedSeconds = volume->GetAllocatedRenderTime();
  if (!mapper->GetAutoAdjustSampleDistances() || allocatedSeconds >= LongestInteractiveSeconds ||
    varimarch::Picks(frame.settings.pass))
  {
    this->Marcher.Draw(frame);
    return;
  }
  varimarch::UseQuality(this->Quality.Next(allocatedSeconds), mapper, frame);
  const int builds = BuildsOf(this->Marcher.Builds());
  frame.window->WaitForCompletion();
  vtkNew<vtkTimerLog> timer;
  timer->StartTimer();
  this->Marcher.Draw(frame);
  frame.window->WaitForCompletion();
  timer->StopTimer();
  if (BuildsOf(this->Marcher.Builds()) == builds)
  {
    this->Quality.Took(timer->GetElapsedTime());
  }
}

vtkStandardNewMacro(vtkVariationFieldVolumeMapper);

vtkVariationFieldVolumeMapper::vtkVariationFieldVolumeMapper()
  : Private(std::make_unique<Internals>())
{
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

void vtkVariationFieldVolumeMapper::Render(vtkRenderer* renderer, vtkVolume* volume)
{
  vtkNew<vtkTimerLog> timer;
  timer->StartTimer();
  this->InvokeEvent(vtkCommand::VolumeMapperRenderStartEvent, nullptr);
  try
  {
    this->DrawFrame(renderer, volume);
    this->Private->ReportedError.clear();
  }
  catch (const std::exception& problem)
  {
    this->ReportOnce(problem.what());
  }
  this->InvokeEvent(vtkCommand::VolumeMapperRenderEndEvent, nullptr);
  timer->StopTimer();
  this->TimeToDraw = timer->GetElapsedTime();
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
  PropOfSelector prop(renderer->GetSelector());
  const std::optional<varimarch::Frame> frame = varimarch::FrameOf(this, renderer, volume);
  if (frame)
  {
    frame->window->MakeCurrent();
    this->Private->DrawInTime(this, volume, *frame);
    prop.TellCounts(this->GetDataSetInput());
    vtkOpenGLCheckErrorMacro("OpenGL error after drawing");
    this->WarnOnce(this->Private->Warnings(this, volume));
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

void vtkVariationFieldVolumeMapper::WarnOnce(const std::string& warning)
{
  if (this->Private->ReportedWarning != warning)
  {
    this->Private->ReportedWarning = warning;
    if (!warning.empty())
    {
      vtkWarningMacro(<< warning);
    }
  }
}

double vtkVariationFieldVolumeMapper::GetUsedSampleDistance()
{
  return this->Private->Marcher.UsedSampleDistanceMm();
}

double vtkVariationFieldVolumeMapper::GetUsedImageSampleDistance()
{
  return this->Private->Marcher.UsedImageSampleDistance();
}

void vtkVariationFieldVolumeMapper::GetColorImage(vtkImageData* image)
{
  const varimarch::Viewport& pixels = this->Private->Marcher.ImagePixels();
  if (pixels.width > 0)
  {
    varimarch::FillColorImage(
      this->Private->Marcher.ColorImage(), pixels.width, pixels.height, image);
  }
}

void vtkVariationFieldVolumeMapper::GetDepthImage(vtkImageData* image)
{
  const varimarch::Viewport& pixels = this->Private->Marcher.ImagePixels();
  if (pixels.width > 0)
  {
    varimarch::FillDepthImage(this->Private->Marcher.DepthImage(), pixels.width, pixels.height,
      this->DepthImageScalarType, image);
  }
}

double vtkVariationFieldVolumeMapper::GetEstimatedError()
{
  const auto& tolerance = this->Private->Marcher.Tolerance();
  return tolerance ? tolerance->step.error : 0.0;
}

void vtkVariationFieldVolumeMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Private->Marcher.Release(window);
}

double vtkVariationFieldVolumeMapper::GetFieldBuildSeconds()
{
  return this->Private->Marcher.FieldBuildSeconds();
}

vtkIdType vtkVariationFieldVolumeMapper::GetGraphicsMemoryBytes()
{
  return vtkIdType(this->Private->Marcher.GraphicsMemoryBytes());
}

void vtkVariationFieldVolumeMapper::GetShaderParts(vtkStringArray* parts)
{
  parts->Initialize();
  for (const std::string& part : this->Private->Marcher.ShaderParts())
  {
    parts->InsertNextValue(part);
  }
}

int vtkVariationFieldVolumeMapper::GetVolumeTextureBuilds()
{
  return this->Private->Marcher.Builds().volumeTexture;
}

int vtkVariationFieldVolumeMapper::GetBlockUploads()
{
  return this->Private->Marcher.BlockUploads();
}

int vtkVariationFieldVolumeMapper::GetBrickRangesBuilds()
{
  return this->Private->Marcher.Builds().brickRanges;
}

int vtkVariationFieldVolumeMapper::GetFieldBuilds()
{
  return this->Private->Marcher.Builds().field;
}

int vtkVariationFieldVolumeMapper::GetOpticalTableBuilds()
{
  return this->Private->Marcher.Builds().opticalTable;
}

int vtkVariationFieldVolumeMapper::GetShaderBuilds()
{
  return this->Private->Marcher.Builds().shader;
}

int vtkVariationFieldVolumeMapper::GetToleranceSearches()
{
  return this->Private->Marcher.Builds().tolerance;
}

int vtkVariationFieldVolumeMapper::FillInputPortInformation(int, vtkInformation* information)
{
  information->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  information->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkRectilinearGrid");
  return 1;
}

void vtkVariationFieldVolumeMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "AccelerationMode: " << this->AccelerationMode << "\n";
  os << indent << "IntegrationRule: " << this->IntegrationRule << "\n";
  os << indent << "DrawFetchCounts: " << this->DrawFetchCounts << "\n";
  os << indent << "VariationTolerance: " << this->VariationTolerance << "\n";
  os << indent << "SampleDistance: " << this->SampleDistance << "\n";
  os << indent << "AutoAdjustSampleDistances: " << this->AutoAdjustSampleDistances << "\n";
  os << indent << "LockSampleDistanceToInputSpacing: " << this->LockSampleDistanceToInputSpacing
     << "\n";
  os << indent << "EarlyTerminationTransmittance: " << this->EarlyTerminationTransmittance << "\n";
  os << indent << "NanColor: " << this->NanColor[0] << ", " << this->NanColor[1] << ", "
     << this->NanColor[2] << "\n";
  os << indent << "NanOpacity: " << this->NanOpacity << "\n";
  os << indent << "ErrorTolerance: " << this->ErrorTolerance << "\n";
  os << indent << "MaximumGraphicsMemory: " << this->MaximumGraphicsMemory << "\n";
  os << indent << "UseJittering: " << this->UseJittering << "\n";
  os << indent << "ImageSampleDistance: " << this->ImageSampleDistance << "\n";
  os << indent << "MinimumImageSampleDistance: " << this->MinimumImageSampleDistance << "\n";
  os << indent << "MaximumImageSampleDistance: " << this->MaximumImageSampleDistance << "\n";
  os << indent << "UsedImageSampleDistance: " << this->GetUsedImageSampleDistance() << "\n";
  os << indent << "RenderToImage: " << this->RenderToImage << "\n";
  os << indent << "DepthImageScalarType: " << this->DepthImageScalarType << "\n";
  os << indent << "ClampDepthToBackface: " << this->ClampDepthToBackface << "\n";
  os << indent << "FinalColorWindow: " << this->FinalColorWindow << "\n";
  os << indent << "FinalColorLevel: " << this->FinalColorLevel << "\n";
  os << indent << "MaskInput: " << this->MaskInput << "\n";
  os << indent << "MaskType: " << this->MaskType << "\n";
  os << indent << "MaskBlendFactor: " << this->MaskBlendFactor << "\n";
  os << indent << "Transfer2DYAxisArray: "
     << (this->Transfer2DYAxisArray ? this->Transfer2DYAxisArray : "none") << "\n";
  os << indent << "UsedSampleDistance: " << this->GetUsedSampleDistance() << "\n";
  os << indent << "EstimatedError: " << this->GetEstimatedError() << "\n";
}
