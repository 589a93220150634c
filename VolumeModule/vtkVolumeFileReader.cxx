#include "vtkVolumeFileReader.h"

#include "Readers/Decoder/DecoderSession.h"
#include "Readers/Dicom/DicomSeries.h"
#include "Readers/Formats.h"
#include "Readers/Packed/KeptInput.h"
#include "Readers/Paging/PagedVoxels.h"
#include "Readers/Times.h"

#include <vtkErrorCode.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkMatrix3x3.h>
#include <vtkObjectFactory.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <new>
#include <optional>
#include <stdexcept>

namespace
{

/// Tells the pipeline the times of a file with several.
void TellTimes(const std::vector<double>& times, vtkInformation* output)
{
  if (times.size() == 1)
  {
    output->Remove(vtkStreamingDemandDrivenPipeline::TIME_STEPS());
    output->Remove(vtkStreamingDemandDrivenPipeline::TIME_RANGE());
    return;
  }
  const double range[2] = { times.front(), times.back() };
  output->Set(vtkStreamingDemandDrivenPipeline::TIME_STEPS(), times.data(), int(times.size()));
  output->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), range, 2);
}

bool IsFormat(int format)
{
  return 0 <= format && format < vtkVolumeFileReader::GetNumberOfFormats();
}

}

/// The volume that was read. The image stays here only from RequestInformation to RequestData,
/// which returns it.
struct vtkVolumeFileReader::Contents
{
  varimarch::Volume Volume;
  int Time = 0;
  vtkNew<vtkStringArray> Warnings;
  bool AreOnDisk = false; ///< true if the image's voxels are those of the file
  bool IsPreview = false;
  /// Copies of the files of a packed DICOM series, which a caller may read after they were listed.
  std::unique_ptr<varimarch::Unpacked> Copies;
};

vtkStandardNewMacro(vtkVolumeFileReader);

vtkVolumeFileReader::vtkVolumeFileReader()
  : Read(std::make_unique<Contents>())
{
  this->SetNumberOfInputPorts(0);
}

vtkVolumeFileReader::~vtkVolumeFileReader()
{
  delete[] this->FileName;
}

void vtkVolumeFileReader::Try(const std::function<void(varimarch::ReadProgress&)>& action)
{
  this->ErrorMessage.clear();
  this->SetErrorCode(vtkErrorCode::NoError);
  this->SetAbortExecute(0);
  if (!this->FileName)
  {
    this->ErrorMessage = "Cannot read a volume: no file name is set; call SetFileName().";
    this->SetErrorCode(vtkErrorCode::NoFileNameError);
    vtkErrorMacro(<< this->ErrorMessage);
    return;
  }
  varimarch::ReadProgress progress(
    [this](double partDone)
    {
      this->UpdateProgress(partDone);
      return !this->GetAbortExecute();
    });
  const varimarch::DecoderSession session(this->LongestSilence);
  try
  {
    action(progress);
  }
  catch (const varimarch::ReadCancelled&)
  {
    this->ErrorMessage = "Reading \"" + std::string(this->FileName) + "\" was stopped.";
    this->SetErrorCode(vtkErrorCode::UserError);
  }
  catch (const std::bad_alloc&)
  {
    this->Fail("Cannot read \"" + std::string(this->FileName) +
      "\": expected memory for its values, found too little; close other programs.");
  }
  catch (const std::exception& error)
  {
    const auto& copies = this->Read->Copies;
    this->Fail(copies ? copies->WithOriginalPaths(error.what()) : error.what());
  }
}

void vtkVolumeFileReader::Fail(const std::string& sentence)
{
  std::error_code ignored;
  this->ErrorMessage = sentence;
  this->SetErrorCode(std::filesystem::exists(this->FileName, ignored)
      ? vtkErrorCode::FileFormatError
      : vtkErrorCode::FileNotFoundError);
  vtkErrorMacro(<< this->ErrorMessage);
}

void vtkVolumeFileReader::ReadFileOrThrow(int time, varimarch::ReadProgress& progress)
{
  varimarch::ReadOptions options;
  std::copy_n(this->RawDimensions, 3, options.raw.dimensions.begin());
  options.raw.scalarType = this->RawScalarType;
  options.raw.componentCount = this->RawNumberOfComponents;
  std::copy_n(this->RawSpacing, 3, options.raw.spacingMm.begin());
  options.raw.headerBytes = this->RawHeaderBytes;
  options.raw.bigEndian = this->RawBigEndian;
  options.series = this->DICOMSeriesUID;
  options.kind = this->DICOMKind;
  options.mostMemoryBytes = std::uint64_t(this->MaximumHostMemory);
  options.rectify = this->RectifySlices ? varimarch::Rectify::Always
    : this->RectifyMisplacedSlices      ? varimarch::Rectify::Misplaced
                                        : varimarch::Rectify::Never;
  options.level =
    this->ResolutionLevel < 0 ? std::nullopt : std::optional<int>(this->ResolutionLevel);
  options.channel = this->Channel;
  options.time = time;
  options.filesAreTimes = this->FilesAreTimes;
  options.kept = this->Kept.get();
  varimarch::PreviewWish preview;
  options.preview = this->PreviewAllowed ? &preview : nullptr;
  this->Read->Volume = varimarch::ReadVolume(this->FileName, options, progress);
  this->Read->IsPreview = !preview.sentence.empty();
  vtkImageData* const image = this->Read->Volume.image;
  this->Read->AreOnDisk = varimarch::PagedVoxelsAt(image->GetScalarPointer()) != nullptr;
  for (const std::string& warning : this->Read->Volume.warnings)
  {
    this->Read->Warnings->InsertNextValue(warning);
  }
}

void vtkVolumeFileReader::ReadFile(int time)
{
  // Nothing is kept of a file that is read anew, since it may have changed.
  if (!this->Kept || this->KeptMTime != this->Superclass::GetMTime())
  {
    this->Kept = std::make_unique<varimarch::KeptInput>();
  }
  this->Read = std::make_unique<Contents>();
  this->Read->Time = time;
  this->Try(
    [this, time](varimarch::ReadProgress& progress) { this->ReadFileOrThrow(time, progress); });
  if (this->Read->Volume.times.values.size() == 1)
  {
    this->Kept.reset();
  }
  this->KeptMTime = this->Superclass::GetMTime();
}

void vtkVolumeFileReader::SetTimeIndex(int index)
{
  if (this->TimeIndex != index)
  {
    this->TimeIndex = index;
    this->TimeIndexChange.Modified();
  }
}

vtkMTimeType vtkVolumeFileReader::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->TimeIndexChange.GetMTime());
}

int vtkVolumeFileReader::RequestedTime(vtkInformation* output)
{
  const std::vector<double>& times = this->Read->Volume.times.values;
  const bool isRequested =
    times.size() > 1 && output->Has(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP());
  return isRequested ? int(varimarch::NearestTime(
                         times, output->Get(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP())))
                     : this->TimeIndex;
}

std::vector<vtkVolumeFileReader::DICOMSeries> vtkVolumeFileReader::ListDICOMSeries()
{
  std::vector<DICOMSeries> list;
  this->Try(
    [this, &list](varimarch::ReadProgress& progress)
    {
      varimarch::ReadProgress unpacking = progress.Part(0.0, 0.5);
      varimarch::ReadProgress finding = progress.Part(0.5, 1.0);
      auto& copies = this->Read->Copies;
      std::vector<std::string> warnings;
      copies = varimarch::UnpackedIfPacked(this->FileName, warnings, unpacking);
      const std::string path = copies ? copies->Path() : this->FileName;
      const varimarch::VolumeFormat* format = varimarch::FormatOfFile(path, {});
      if (format && format->read != varimarch::ReadDicom)
      {
        return;
      }
      for (const auto& series : varimarch::FindDicomSeries(path, finding).series)
      {
        const auto imageCount = std::int64_t(series.frames.size());
        const varimarch::DicomFile& middle = *series.frames[series.frames.size() / 2].file;
        list.push_back({ series.uid, series.description, series.modality, imageCount, middle.path,
          middle.frameOfReference });
      }
    });
  return list;
}

int vtkVolumeFileReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  this->ReadFile(this->TimeIndex);
  vtkInformation* output = outputs->GetInformationObject(0);
  TellTimes(this->Read->Volume.times.values, output);
  vtkImageData* const image = this->Read->Volume.image;
  const int empty[6] = { 0, -1, 0, -1, 0, -1 };
  output->Set(
    vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), image ? image->GetExtent() : empty, 6);
  if (image)
  {
    output->Set(vtkDataObject::SPACING(), image->GetSpacing(), 3);
    output->Set(vtkDataObject::ORIGIN(), image->GetOrigin(), 3);
    output->Set(vtkDataObject::DIRECTION(), image->GetDirectionMatrix()->GetData(), 9);
    vtkDataObject::SetPointDataActiveScalarInfo(
      output, image->GetScalarType(), image->GetNumberOfScalarComponents());
  }
  // Returns 1 after a failure too: with 0 the executive would add an error message of its own.
  return 1;
}

int vtkVolumeFileReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  // Another time is requested, or the output was released after an earlier request.
  const int time = this->RequestedTime(outputs->GetInformationObject(0));
  const bool isRead = this->Read->Volume.image && this->Read->Time == time;
  if (!isRead && this->GetErrorCode() == vtkErrorCode::NoError)
  {
    this->ReadFile(time);
  }
  vtkImageData* output = vtkImageData::GetData(outputs);
  if (this->Read->Volume.image)
  {
    output->ShallowCopy(this->Read->Volume.image);
    this->Read->Volume.image = nullptr;
    output->GetInformation()->Set(
      vtkDataObject::DATA_TIME_STEP(), this->Read->Volume.times.values[std::size_t(time)]);
  }
  else
  {
    output->Initialize();
  }
  return 1;
}

bool vtkVolumeFileReader::IsPreview()
{
  return this->Read->IsPreview;
}

int vtkVolumeFileReader::GetNumberOfDICOMKinds()
{
  return int(this->Read->Volume.kinds.size());
}

const char* vtkVolumeFileReader::GetDICOMKindName(int kind)
{
  const std::vector<std::string>& kinds = this->Read->Volume.kinds;
  const bool isKnown = kind >= 1 && kind <= int(kinds.size());
  return isKnown ? kinds[std::size_t(kind) - 1].c_str() : "";
}

bool vtkVolumeFileReader::IsInverted()
{
  return this->Read->Volume.isInverted;
}

bool vtkVolumeFileReader::HasVoxelsOnDisk()
{
  return this->Read->AreOnDisk;
}

const char* vtkVolumeFileReader::GetModality()
{
  return this->Read->Volume.modality.c_str();
}

const char* vtkVolumeFileReader::GetBodyPart()
{
  return this->Read->Volume.bodyPart.c_str();
}

bool vtkVolumeFileReader::HasContrastAgent()
{
  return this->Read->Volume.hasContrastAgent;
}

const char* vtkVolumeFileReader::GetWeighting()
{
  return this->Read->Volume.weighting.c_str();
}

bool vtkVolumeFileReader::HasWindowLevel()
{
  return this->Read->Volume.windowLevel.has_value();
}

double vtkVolumeFileReader::GetWindow()
{
  return this->HasWindowLevel() ? this->Read->Volume.windowLevel->window : 0.0;
}

double vtkVolumeFileReader::GetLevel()
{
  return this->HasWindowLevel() ? this->Read->Volume.windowLevel->level : 0.0;
}

bool vtkVolumeFileReader::HasIrregularSlices()
{
  return !this->Read->Volume.irregularSlicesMm.empty();
}

bool vtkVolumeFileReader::HasRectifiedSlices()
{
  return this->Read->Volume.isRectified;
}

double vtkVolumeFileReader::GetUptakeValueFactor()
{
  return this->Read->Volume.uptakeValueFactor.value_or(0.0);
}

int vtkVolumeFileReader::GetNumberOfTimes()
{
  return int(this->Read->Volume.times.values.size());
}

double vtkVolumeFileReader::GetTimeValue(int time)
{
  const std::vector<double>& times = this->Read->Volume.times.values;
  return time >= 0 && time < int(times.size()) ? times[std::size_t(time)] : 0.0;
}

bool vtkVolumeFileReader::HasTimesInSeconds()
{
  return this->Read->Volume.times.areSeconds;
}

int vtkVolumeFileReader::GetReadTime()
{
  return this->Read->Time;
}

const char* vtkVolumeFileReader::GetFrameOfReferenceUID()
{
  return this->Read->Volume.frameOfReference.c_str();
}

bool vtkVolumeFileReader::HoldsLabels()
{
  return this->Read->Volume.segments.has_value();
}

std::vector<vtkVolumeFileReader::Segment> vtkVolumeFileReader::GetSegments()
{
  std::vector<Segment> list;
  const auto& segments = this->Read->Volume.segments;
  for (const auto& segment : segments.value_or(std::vector<varimarch::LabelledSegment>()))
  {
    const glm::dvec3 rgb = segment.rgb.value_or(glm::dvec3(0.0));
    list.push_back(
      { segment.value, segment.name, segment.rgb.has_value(), { rgb.r, rgb.g, rgb.b } });
  }
  return list;
}

vtkStringArray* vtkVolumeFileReader::GetWarnings()
{
  return this->Read->Warnings;
}

const char* vtkVolumeFileReader::GetErrorMessage()
{
  return this->ErrorMessage.c_str();
}

int vtkVolumeFileReader::GetNumberOfFormats()
{
  return int(varimarch::VolumeFormats().size());
}

const char* vtkVolumeFileReader::GetFormatName(int format)
{
  return IsFormat(format) ? varimarch::VolumeFormats()[format].name : nullptr;
}

const char* vtkVolumeFileReader::GetFormatDescription(int format)
{
  return IsFormat(format) ? varimarch::VolumeFormats()[format].description : nullptr;
}

std::string vtkVolumeFileReader::GetFormatExtensions(int format)
{
  std::string all;
  if (!IsFormat(format))
  {
    return all;
  }
  for (const std::string& extension : varimarch::VolumeFormats()[format].extensions)
  {
    all += (all.empty() ? "" : " ") + extension;
  }
  return all;
}

const char* vtkVolumeFileReader::GetFormatOfFile(const char* path)
{
  const varimarch::DecoderSession session;
  const auto* format = path ? varimarch::FormatIfReadable(path) : nullptr;
  return format ? format->name : nullptr;
}

bool vtkVolumeFileReader::CanReadFile(const char* path)
{
  const varimarch::DecoderSession session;
  return path && varimarch::LooksReadable(path);
}

void vtkVolumeFileReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << '\n';
  os << indent << "RawDimensions: " << this->RawDimensions[0] << ' ' << this->RawDimensions[1]
     << ' ' << this->RawDimensions[2] << '\n';
  os << indent << "RawScalarType: " << vtkImageScalarTypeNameMacro(this->RawScalarType) << '\n';
  os << indent << "RawNumberOfComponents: " << this->RawNumberOfComponents << '\n';
  os << indent << "RawSpacing: " << this->RawSpacing[0] << ' ' << this->RawSpacing[1] << ' '
     << this->RawSpacing[2] << '\n';
  os << indent << "RawHeaderBytes: " << this->RawHeaderBytes << '\n';
  os << indent << "RawBigEndian: " << this->RawBigEndian << '\n';
  os << indent << "DICOMSeriesUID: " << this->DICOMSeriesUID << '\n';
  os << indent << "DICOMKind: " << this->DICOMKind << '\n';
  os << indent << "RectifySlices: " << this->RectifySlices << '\n';
  os << indent << "RectifyMisplacedSlices: " << this->RectifyMisplacedSlices << '\n';
  os << indent << "MaximumHostMemory: " << this->MaximumHostMemory << '\n';
  os << indent << "PreviewAllowed: " << this->PreviewAllowed << '\n';
  os << indent << "ResolutionLevel: " << this->ResolutionLevel << '\n';
  os << indent << "Channel: " << this->Channel << '\n';
  os << indent << "TimeIndex: " << this->TimeIndex << '\n';
  os << indent << "FilesAreTimes: " << this->FilesAreTimes << '\n';
  os << indent << "LongestSilence: " << this->LongestSilence << '\n';
  os << indent << "ErrorMessage: " << this->ErrorMessage << '\n';
}
