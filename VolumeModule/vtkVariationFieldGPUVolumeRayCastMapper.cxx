#include "vtkVariationFieldGPUVolumeRayCastMapper.h"

#include "Frame/MissingFeatures.h"
#include "VtkVersions.h"
#include "vtkVariationFieldVolumeMapper.h"

#include "vtkAlgorithmOutput.h"
#include "vtkCommand.h"
#include "vtkContourValues.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPlaneCollection.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <atomic>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <iostream>

namespace
{

// A setting that only VTK's mapper supports, and the sentence that reports it.
struct Setting
{
  bool isUsed;
  const char* sentence;
};

bool IsErrorTolerance(double tolerance)
{
  return tolerance >= 0.0 && tolerance <= 1.0; // false for NaN
}

double ErrorToleranceFromEnvironment()
{
  const double usual = vtkNew<vtkVariationFieldVolumeMapper>()->GetErrorTolerance();
  const char* const text = std::getenv("VARIMARCH_ERROR_TOLERANCE");
  if (!text)
  {
    return usual;
  }
  const char* const end = text + std::strlen(text);
  double tolerance = -1.0;
  const auto [stop, error] = std::from_chars(text, end, tolerance);
  if (stop == end && error == std::errc() && IsErrorTolerance(tolerance))
  {
    return tolerance;
  }
  vtkGenericWarningMacro("The environment variable VARIMARCH_ERROR_TOLERANCE is \""
    << text << "\": expected a number from 0 to 1; images keep " << usual);
  return usual;
}

// Programs may make mappers in several threads.
std::atomic<double>& DefaultErrorTolerance()
{
  static std::atomic<double> tolerance(ErrorToleranceFromEnvironment());
  return tolerance;
}

}

vtkStandardNewMacro(vtkVariationFieldGPUVolumeRayCastMapper);

vtkVariationFieldGPUVolumeRayCastMapper::vtkVariationFieldGPUVolumeRayCastMapper()
{
  this->VariationFieldMapper->SetErrorTolerance(GetDefaultErrorTolerance());
}

vtkVariationFieldGPUVolumeRayCastMapper::~vtkVariationFieldGPUVolumeRayCastMapper() = default;

void vtkVariationFieldGPUVolumeRayCastMapper::SetDefaultErrorTolerance(double tolerance)
{
  if (!IsErrorTolerance(tolerance))
  {
    vtkGenericWarningMacro("The default error tolerance stays "
      << GetDefaultErrorTolerance() << ": expected a number from 0 to 1, found " << tolerance);
    return;
  }
  DefaultErrorTolerance() = tolerance;
}

double vtkVariationFieldGPUVolumeRayCastMapper::GetDefaultErrorTolerance()
{
  return DefaultErrorTolerance();
}

vtkVariationFieldVolumeMapper* vtkVariationFieldGPUVolumeRayCastMapper::GetVariationFieldMapper()
{
  return this->VariationFieldMapper;
}

const char* vtkVariationFieldGPUVolumeRayCastMapper::GetReasonForVtkMapper()
{
  return this->ReasonForVtkMapper.c_str();
}

void vtkVariationFieldGPUVolumeRayCastMapper::ForwardSettings()
{
  vtkVariationFieldVolumeMapper* mapper = this->VariationFieldMapper;
  for (int port = 0; port < mapper->GetNumberOfInputPorts(); ++port)
  {
    const bool hasInput = this->GetNumberOfInputConnections(port) > 0;
    mapper->SetInputConnection(port, hasInput ? this->GetInputConnection(port, 0) : nullptr);
  }
  mapper->SetScalarMode(this->ScalarMode);
  mapper->SelectScalarArray(this->ArrayId);
  mapper->SelectScalarArray(this->ArrayName);
  mapper->SetArrayAccessMode(this->ArrayAccessMode);
  mapper->SetBlendMode(this->BlendMode);
  mapper->SetAverageIPScalarRange(this->AverageIPScalarRange);
  mapper->SetCropping(this->Cropping);
  mapper->SetCroppingRegionPlanes(this->CroppingRegionPlanes);
  mapper->SetCroppingRegionFlags(this->CroppingRegionFlags);
  mapper->SetClippingPlanes(this->ClippingPlanes);
  mapper->SetMaskInput(this->MaskInput);
  mapper->SetMaskType(this->MaskType);
  mapper->SetMaskBlendFactor(this->MaskBlendFactor);
  mapper->SetTransfer2DYAxisArray(this->Transfer2DYAxisArray);
  mapper->SetSampleDistance(this->SampleDistance);
  // VTK's mapper also ignores its sample distance if that is locked to the spacing.
  mapper->SetAutoAdjustSampleDistances(
    this->AutoAdjustSampleDistances || this->LockSampleDistanceToInputSpacing);
  mapper->SetImageSampleDistance(this->ImageSampleDistance);
  mapper->SetMinimumImageSampleDistance(this->MinimumImageSampleDistance);
  mapper->SetMaximumImageSampleDistance(this->MaximumImageSampleDistance);
  mapper->SetRenderToImage(this->RenderToImage);
  mapper->SetDepthImageScalarType(this->DepthImageScalarType);
  mapper->SetClampDepthToBackface(this->ClampDepthToBackface);
  mapper->SetUseJittering(this->UseJittering);
  mapper->SetFinalColorWindow(this->FinalColorWindow);
  mapper->SetFinalColorLevel(this->FinalColorLevel);
  varimarch::CopyScattering(this, mapper);
  varimarch::CopyShadingByOpacity(this, mapper);
}

// Settings that vtkVariationFieldVolumeMapper does not have.
std::string vtkVariationFieldGPUVolumeRayCastMapper::UnsupportedSetting()
{
  const Setting settings[] = {
    { this->UseDepthPass != 0, "The depth pass (UseDepthPass) is not supported yet. " },
    { this->ColorRangeType != SCALAR || this->ScalarOpacityRangeType != SCALAR ||
        this->GradientOpacityRangeType != SCALAR,
      "Transfer functions with a range type other than SCALAR are not supported yet. " },
  };
  std::string sentences;
  for (const Setting& setting : settings)
  {
    sentences += setting.isUsed ? setting.sentence : "";
  }
  return sentences;
}

bool vtkVariationFieldGPUVolumeRayCastMapper::ChooseMapper(vtkRenderer* renderer, vtkVolume* volume)
{
  const bool wasVtk = !this->ReasonForVtkMapper.empty();
  this->ForwardSettings();
  this->ReasonForVtkMapper = this->UnsupportedSetting() +
    varimarch::UnsupportedFeature(this->VariationFieldMapper, renderer, volume);
  const bool isVtk = !this->ReasonForVtkMapper.empty();

  // One copy of the volume in graphics memory is enough. VTK's mapper may have loaded its copy
  // earlier.
  vtkWindow* window = renderer->GetRenderWindow();
  if (isVtk && !wasVtk)
  {
    this->VariationFieldMapper->ReleaseGraphicsResources(window);
  }
  else if (!isVtk)
  {
    this->Superclass::ReleaseGraphicsResources(window);
  }

  const std::string choice = isVtk ? "VTK's mapper draws. " + this->ReasonForVtkMapper
                                   : "The variation field mapper draws. ";
  if (this->ReportedChoice != choice)
  {
    this->ReportedChoice = choice;
    vtkDebugMacro(<< choice);
    if (std::getenv("VARIMARCH_VERBOSE"))
    {
      std::cerr << "Varimarch: " << choice << '\n';
    }
  }
  return !isVtk;
}

void vtkVariationFieldGPUVolumeRayCastMapper::Draw(vtkRenderer* renderer, vtkVolume* volume)
{
  this->InvokeEvent(vtkCommand::VolumeMapperRenderStartEvent, nullptr);
  this->VariationFieldMapper->Render(renderer, volume);
  this->TimeToDraw = this->VariationFieldMapper->GetTimeToDraw();
  this->InvokeEvent(vtkCommand::VolumeMapperRenderEndEvent, nullptr);
}

void vtkVariationFieldGPUVolumeRayCastMapper::Render(vtkRenderer* renderer, vtkVolume* volume)
{
  for (int port = 0; port < this->GetNumberOfInputPorts(); ++port)
  {
    if (this->GetNumberOfInputConnections(port) > 0)
    {
      this->GetInputAlgorithm(port, 0)->Update();
    }
  }
  if (this->ChooseMapper(renderer, volume))
  {
    this->Draw(renderer, volume);
  }
  else
  {
    this->Superclass::Render(renderer, volume);
  }
}

void vtkVariationFieldGPUVolumeRayCastMapper::GetColorImage(vtkImageData* image)
{
  const bool isOurs = this->ReasonForVtkMapper.empty();
  isOurs ? this->VariationFieldMapper->GetColorImage(image)
         : this->Superclass::GetColorImage(image);
}

void vtkVariationFieldGPUVolumeRayCastMapper::GetDepthImage(vtkImageData* image)
{
  const bool isOurs = this->ReasonForVtkMapper.empty();
  isOurs ? this->VariationFieldMapper->GetDepthImage(image)
         : this->Superclass::GetDepthImage(image);
}

void vtkVariationFieldGPUVolumeRayCastMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->VariationFieldMapper->ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

void vtkVariationFieldGPUVolumeRayCastMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ReasonForVtkMapper: " << this->ReasonForVtkMapper << "\n";
  os << indent << "VariationFieldMapper:\n";
  this->VariationFieldMapper->PrintSelf(os, indent.GetNextIndent());
}

// For VolumeModule/Plugin/Factory.cxx, which loads this library by name and cannot link to it.
extern "C" VARIMARCHVOLUME_EXPORT vtkObject* VarimarchNewGPUVolumeRayCastMapper()
{
  return vtkVariationFieldGPUVolumeRayCastMapper::New();
}
