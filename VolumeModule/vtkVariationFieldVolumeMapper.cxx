#include "vtkVariationFieldVolumeMapper.h"

#include "RayMarcher.h"

#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLError.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPlaneCollection.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkStringArray.h"
#include "vtkTimerLog.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>

using varimarch::Acceleration;
using varimarch::Blend;
using varimarch::Frame;
using varimarch::Integration;

struct vtkVariationFieldVolumeMapper::Internals
{
  varimarch::RayMarcher Marcher;
  std::string ReportedError; ///< the one the user has already been told
  std::string ReportedWarning;

  static void ChooseSampling(const vtkVariationFieldVolumeMapper* mapper, Frame& frame);
  std::string Shortcomings(vtkVariationFieldVolumeMapper* mapper) const;
};

namespace
{

bool HasOpaqueGeometry(vtkRenderer* renderer)
{
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator iterator;
  props->InitTraversal(iterator);
  while (vtkProp* prop = props->GetNextProp(iterator))
  {
    // vtkVolume does not override HasOpaqueGeometry, whose default is yes.
    if (prop->GetVisibility() && !vtkVolume::SafeDownCast(prop) && prop->HasOpaqueGeometry())
    {
      return true;
    }
  }
  // Another renderer's geometry, in a layer below this one.
  return renderer->GetPreserveDepthBuffer() != 0;
}

Blend BlendOf(int blendMode)
{
  switch (blendMode)
  {
    case vtkVolumeMapper::COMPOSITE_BLEND:
      return Blend::Composite;
    case vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND:
      return Blend::MaximumIntensity;
    case vtkVolumeMapper::MINIMUM_INTENSITY_BLEND:
      return Blend::MinimumIntensity;
    case vtkVolumeMapper::AVERAGE_INTENSITY_BLEND:
      return Blend::AverageIntensity;
    case vtkVolumeMapper::ADDITIVE_BLEND:
      return Blend::Additive;
  }
  throw std::runtime_error("Blend mode " + std::to_string(blendMode) +
    " is not supported: expected composite (0), maximum (1), minimum (2) or average intensity (3), "
    "or "
    "additive (4)");
}

Acceleration AccelerationOf(int accelerationMode, Blend blend)
{
  switch (accelerationMode)
  {
    case vtkVariationFieldVolumeMapper::ScalarField:
      return Acceleration::ScalarField;
    case vtkVariationFieldVolumeMapper::OpticalField:
      // What is invisible to a composite counts in a sum of values.
      return blend == Blend::Composite || varimarch::IsExtreme(blend) ? Acceleration::OpticalField
                                                                      : Acceleration::Off;
  }
  return Acceleration::Off;
}

Integration IntegrationOf(int integrationRule)
{
  switch (integrationRule)
  {
    case vtkVariationFieldVolumeMapper::PreIntegrated:
      return Integration::PreIntegrated;
    case vtkVariationFieldVolumeMapper::Simpson:
      return Integration::Simpson;
    case vtkVariationFieldVolumeMapper::PublishedSum:
      return Integration::PublishedSum;
  }
  return Integration::Midpoint;
}

// Samples per voxel that keep a composite within half a grey level of a fine march, measured on a
// head CT with a bone transfer function. Normals turn faster than values change; a maximum needs
// no more than to pass close by.
double AutomaticSamplesPerVoxel(const varimarch::RenderSettings& settings)
{
  if (settings.blend != Blend::Composite)
  {
    return 2.0;
  }
  return settings.shading ? 8.0 : 4.0;
}

// A homogeneous material as a transfer function of one node would have it.
glm::dvec4 GapOptical(const double color[3], double opacity, double unitDistanceMm)
{
  const varimarch::TransferFunction material(
    { { 0.0, { color[0], color[1], color[2] } } }, { { 0.0, opacity } }, unitDistanceMm);
  const double extinction = std::min(material.Extinction(0.0), double(varimarch::OpaqueExtinction));
  return glm::dvec4(material.Color(0.0), extinction);
}

// The scalars to draw. Throws a sentence that tells what is wrong with the input.
vtkDataArray* CheckedScalars(vtkImageData* image, vtkDataArray* scalars, int cellFlag)
{
  if (!scalars)
  {
    throw std::runtime_error("The input has no scalars to draw");
  }
  const std::string name = scalars->GetName() ? scalars->GetName() : "scalars";
  if (cellFlag != 0)
  {
    throw std::runtime_error("Array \"" + name + "\" holds cell data: expected point data");
  }
  if (scalars->GetNumberOfComponents() != 1)
  {
    throw std::runtime_error("Array \"" + name + "\" has " +
      std::to_string(scalars->GetNumberOfComponents()) + " components: expected 1");
  }
  if (scalars->GetNumberOfTuples() != image->GetNumberOfPoints())
  {
    throw std::runtime_error("Array \"" + name + "\" has " +
      std::to_string(scalars->GetNumberOfTuples()) + " values: expected one for each of " +
      std::to_string(image->GetNumberOfPoints()) + " points");
  }
  return scalars;
}

}

void vtkVariationFieldVolumeMapper::Internals::ChooseSampling(
  const vtkVariationFieldVolumeMapper* mapper, Frame& frame)
{
  // Of the tolerance, the field and the early end of rays may use an eighth each.
  constexpr double Share = 1.0 / 8.0;
  constexpr double FieldErrorWithoutTolerance = 1.0 / 255.0;
  frame.settings.integration = IntegrationOf(mapper->IntegrationRule);
  frame.chooseIntegration = mapper->IntegrationRule == Automatic &&
    frame.settings.blend == Blend::Composite && !frame.settings.shading;
  frame.variationTolerance = mapper->VariationTolerance;
  frame.errorTolerance = mapper->AutoAdjustSampleDistances ? mapper->ErrorTolerance : 0.0;
  const bool tolerance = frame.errorTolerance > 0.0;
  frame.fieldError = tolerance ? Share * frame.errorTolerance : FieldErrorWithoutTolerance;
  frame.earlyTerminationTransmittance =
    tolerance ? Share * frame.errorTolerance : mapper->EarlyTerminationTransmittance;
  frame.sampleDistanceMm = mapper->AutoAdjustSampleDistances
    ? frame.geometry.SmallestSpacingMm() / AutomaticSamplesPerVoxel(frame.settings)
    : std::max(mapper->SampleDistance, frame.geometry.ShortestSampleDistanceMm());
}

// What the picture lacks of what was asked for; empty when it lacks nothing.
std::string vtkVariationFieldVolumeMapper::Internals::Shortcomings(
  vtkVariationFieldVolumeMapper* mapper) const
{
  std::string shortcomings;
  if (mapper->GetCropping())
  {
    shortcomings += "Cropping is not supported yet: the whole volume is drawn. ";
  }
  if (mapper->GetClippingPlanes() && mapper->GetClippingPlanes()->GetNumberOfItems() > 0)
  {
    shortcomings += "Clipping planes are not supported yet: the whole volume is drawn. ";
  }
  if (!mapper->GetAutoAdjustSampleDistances() &&
    this->Marcher.UsedSampleDistanceMm() > mapper->GetSampleDistance())
  {
    std::ostringstream text;
    text << "The sample distance " << mapper->GetSampleDistance()
         << " is too short for this volume: " << this->Marcher.UsedSampleDistanceMm()
         << " is used, 2^16 samples along its diagonal. ";
    shortcomings += text.str();
  }
  if (this->Marcher.Tolerance() && !this->Marcher.Tolerance()->step.KeepsLimit())
  {
    std::ostringstream text;
    const varimarch::StepChoice& step = this->Marcher.Tolerance()->step;
    text << "The error tolerance " << mapper->ErrorTolerance
         << " cannot be kept: with a sample every " << step.sampleDistance
         << ", 99.9 % of the pixels are off by up to " << step.error << ". ";
    shortcomings += text.str();
  }
  return shortcomings;
}

vtkStandardNewMacro(vtkVariationFieldVolumeMapper);

vtkVariationFieldVolumeMapper::vtkVariationFieldVolumeMapper()
  : Private(std::make_unique<Internals>())
{
}

vtkVariationFieldVolumeMapper::~vtkVariationFieldVolumeMapper() = default;

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

void vtkVariationFieldVolumeMapper::DrawFrame(vtkRenderer* renderer, vtkVolume* volume)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  auto* image = vtkImageData::SafeDownCast(this->GetInput());
  if (!window || !image)
  {
    throw std::runtime_error(
      window ? "The input is not vtkImageData" : "The render window does not use OpenGL");
  }
  if (image->GetNumberOfPoints() == 0)
  {
    return;
  }
  int cellFlag = 0;
  vtkDataArray* scalars = vtkAbstractVolumeMapper::GetScalars(
    image, this->ScalarMode, this->ArrayAccessMode, this->ArrayId, this->ArrayName, cellFlag);

  Frame frame;
  frame.window = window;
  frame.renderer = renderer;
  frame.property = volume->GetProperty();
  frame.scalars = CheckedScalars(image, scalars, cellFlag);
  frame.scalarsTime = std::max(image->GetMTime(), scalars->GetMTime());
  frame.geometry = varimarch::VolumeGeometryOf(image, volume);
  frame.settings.blend = BlendOf(this->BlendMode);
  frame.settings.acceleration = AccelerationOf(this->AccelerationMode, frame.settings.blend);
  frame.settings.shading =
    frame.property->GetShade() != 0 && frame.settings.blend == Blend::Composite;
  frame.settings.countFetches = this->DrawFetchCounts;
  frame.settings.sceneGeometry = HasOpaqueGeometry(renderer);
  frame.averagedRange = { this->AverageIPScalarRange[0], this->AverageIPScalarRange[1] };
  frame.settings.fillGaps = this->NanOpacity > 0.0;
  frame.gapOptical =
    GapOptical(this->NanColor, this->NanOpacity, frame.property->GetScalarOpacityUnitDistance());
  frame.viewport = varimarch::ViewportOf(renderer);
  frame.mostMemoryBytes = std::size_t(this->MaximumGraphicsMemory);
  Internals::ChooseSampling(this, frame);

  window->MakeCurrent();
  this->Private->Marcher.Draw(frame);
  vtkOpenGLCheckErrorMacro("OpenGL error after drawing");
  this->WarnOnce(this->Private->Shortcomings(this));
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
  os << indent << "EarlyTerminationTransmittance: " << this->EarlyTerminationTransmittance << "\n";
  os << indent << "NanColor: " << this->NanColor[0] << ", " << this->NanColor[1] << ", "
     << this->NanColor[2] << "\n";
  os << indent << "NanOpacity: " << this->NanOpacity << "\n";
  os << indent << "ErrorTolerance: " << this->ErrorTolerance << "\n";
  os << indent << "MaximumGraphicsMemory: " << this->MaximumGraphicsMemory << "\n";
  os << indent << "UsedSampleDistance: " << this->GetUsedSampleDistance() << "\n";
  os << indent << "EstimatedError: " << this->GetEstimatedError() << "\n";
}
