#include "Scene/Volumes/VolumeLoading.h"

#include "Readers/VolumeFile.h"
#include "Scene/Json/SceneNames.h"
#include "Scene/Segments/Segments.h"
#include "Scene/Volumes/ImageStatistics.h"
#include "Scene/Volumes/ProceduralVolume.h"

#include <vtkCallbackCommand.h>
#include <vtkDataArray.h>
#include <vtkErrorCode.h>
#include <vtkImageData.h>
#include <vtkImageShrink3D.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkVolumeFileReader.h>
#include <vtksys/SystemTools.hxx>

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <stdexcept>

namespace varimarch
{

namespace
{

void Apply(const RawLayout& raw, vtkVolumeFileReader* reader)
{
  reader->SetRawDimensions(raw.dimensions[0], raw.dimensions[1], raw.dimensions[2]);
  reader->SetRawScalarType(ValueOf(RawTypeNames(), raw.type));
  reader->SetRawSpacing(raw.spacingMm[0], raw.spacingMm[1], raw.spacingMm[2]);
  reader->SetRawBigEndian(raw.bigEndian);
  reader->SetRawHeaderBytes(raw.headerBytes);
}

// Forwards progress to the observer, and its request to cancel to the reader.
void Observe(vtkVolumeFileReader* reader, const LoadObserver& observer)
{
  vtkNew<vtkCallbackCommand> progress;
  progress->SetClientData(const_cast<LoadObserver*>(&observer));
  progress->SetCallback(
    [](vtkObject* caller, unsigned long, void* client, void* part)
    {
      if (!(*static_cast<const LoadObserver*>(client))(*static_cast<const double*>(part)))
      {
        static_cast<vtkVolumeFileReader*>(caller)->SetAbortExecute(1);
      }
    });
  reader->AddObserver(vtkCommand::ProgressEvent, progress);
}

// A reader that throws its errors as exceptions.
class QuietReader
{
public:
  QuietReader(const std::string& path, const LoadObserver& observer)
    : path(path)
  {
    // While an observer listens to errors, VTK does not print them.
    vtkNew<vtkCallbackCommand> nothing;
    nothing->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
    this->reader->AddObserver(vtkCommand::ErrorEvent, nothing);
    this->reader->SetFileName(path.c_str());
    if (observer)
    {
      Observe(this->reader, observer);
    }
  }

  vtkVolumeFileReader* operator->() { return this->reader; }

  // Throws the error of the last operation, if any.
  void Check()
  {
    if (this->reader->GetErrorCode() == vtkErrorCode::UserError)
    {
      throw std::runtime_error("Reading " + this->path + " was stopped");
    }
    if (this->reader->GetErrorCode() != vtkErrorCode::NoError)
    {
      throw std::runtime_error(this->reader->GetErrorMessage());
    }
  }

private:
  std::string path;
  vtkNew<vtkVolumeFileReader> reader;
};

// Completes the segments that a file describes. Too many labels stay plain values.
void TakeSegments(const std::vector<vtkVolumeFileReader::Segment>& described, LoadedVolume& volume)
{
  std::vector<Segment> known;
  for (const vtkVolumeFileReader::Segment& segment : described)
  {
    const glm::dvec3 rgb =
      segment.HasColor ? glm::make_vec3(segment.Color) : ColorOfLabel(segment.Value);
    known.push_back(
      { segment.Value, segment.Name.empty() ? NameOfLabel(segment.Value) : segment.Name, rgb });
  }
  try
  {
    volume.segments = SegmentsOf(volume.image, known, volume.warnings);
  }
  catch (const std::invalid_argument& reason)
  {
    volume.warnings.push_back(
      std::string("The labels are drawn as values without colours: ") + reason.what() + ".");
  }
}

void Apply(const FileSource& source, QuietReader& reader)
{
  reader->SetFilesAreTimes(source.filesAreTimes);
  reader->SetDICOMSeriesUID(source.series.c_str());
  reader->SetDICOMKind(source.kind);
  reader->SetMaximumHostMemory(vtkIdType(1e6 * source.memoryMegabytes));
  reader->SetRectifySlices(source.rectified.value_or(false));
  reader->SetRectifyMisplacedSlices(!source.rectified);
  reader->SetResolutionLevel(source.level.value_or(-1));
  reader->SetChannel(source.channel.value_or(AllChannels));
  if (source.raw)
  {
    Apply(*source.raw, reader.operator->());
  }
}

LoadedTimes TimesOf(QuietReader& reader)
{
  LoadedTimes times;
  times.values.clear();
  for (int time = 0; time < reader->GetNumberOfTimes(); ++time)
  {
    times.values.push_back(reader->GetTimeValue(time));
  }
  times.areSeconds = reader->HasTimesInSeconds();
  times.current = reader->GetReadTime();
  return times;
}

// The volume of a reader that has read one.
LoadedVolume VolumeOf(QuietReader& reader)
{
  LoadedVolume volume = { reader->GetOutput(), reader->GetModality(), {} };
  volume.isOnDisk = reader->HasVoxelsOnDisk();
  volume.isPreview = reader->IsPreview();
  volume.bodyPart = reader->GetBodyPart();
  volume.hasContrastAgent = reader->HasContrastAgent();
  volume.weighting = reader->GetWeighting();
  if (reader->HasWindowLevel())
  {
    volume.windowLevel = { reader->GetWindow(), reader->GetLevel() };
  }
  volume.isInverted = reader->IsInverted();
  if (reader->HasIrregularSlices())
  {
    volume.slices = reader->HasRectifiedSlices() ? SliceLayout::Rectified : SliceLayout::Irregular;
  }
  volume.uptakeValueFactor = reader->GetUptakeValueFactor();
  volume.frameOfReference = reader->GetFrameOfReferenceUID();
  volume.times = TimesOf(reader);
  for (int kind = 1; kind <= reader->GetNumberOfDICOMKinds(); ++kind)
  {
    volume.kinds.emplace_back(reader->GetDICOMKindName(kind));
  }
  if (reader->HoldsLabels())
  {
    TakeSegments(reader->GetSegments(), volume);
  }
  vtkStringArray* warnings = reader->GetWarnings();
  for (vtkIdType i = 0; i < warnings->GetNumberOfValues(); ++i)
  {
    volume.warnings.push_back(warnings->GetValue(i));
  }
  return volume;
}

// Reads the time that lies nearest to one in seconds.
void ReadNearest(const FileSource& source, QuietReader& reader)
{
  reader->UpdateInformation();
  reader.Check();
  if (!reader->HasTimesInSeconds())
  {
    const int count = reader->GetNumberOfTimes();
    throw std::runtime_error("Cannot read a time of \"" + source.path +
      "\" by its seconds: expected a file that states its times in seconds, found " +
      (count > 1 ? std::to_string(count) + " times that only have numbers" : "a single volume"));
  }
  reader->UpdateTimeStep(*source.timeSeconds);
}

LoadedVolume ReadFile(
  const FileSource& source, const LoadObserver& observer, bool mayBePreview = false)
{
  QuietReader reader(source.path, observer);
  Apply(source, reader);
  reader->SetPreviewAllowed(mayBePreview);
  if (source.timeSeconds)
  {
    ReadNearest(source, reader);
  }
  else
  {
    reader->SetTimeIndex(source.time);
    reader->Update();
  }
  reader.Check();
  return VolumeOf(reader);
}

// The UID of the first segmentation; empty if there is none.
std::string SegmentationSeries(const std::string& path, const LoadObserver& observer)
{
  QuietReader reader(path, observer);
  const auto found = reader->ListDICOMSeries();
  reader.Check();
  const auto segmentation = std::find_if(found.begin(), found.end(),
    [](const vtkVolumeFileReader::DICOMSeries& series) { return series.Modality == "SEG"; });
  return segmentation == found.end() ? std::string() : segmentation->UID;
}

GrayPicture MiddleOfFile(const std::string& path)
{
  try
  {
    return MiddleSlice(ReadFile({ path, std::nullopt }, {}).image);
  }
  catch (const std::runtime_error&)
  {
    // The error is reported when the user opens the series.
    return {};
  }
}

}

LoadedVolume LoadVolume(const VolumeSource& source, const LoadObserver& observer, bool mayBePreview)
{
  if (const auto* procedural = std::get_if<ProceduralSource>(&source))
  {
    const bool isCT = procedural->kind == ProceduralKind::Torso;
    return { ProceduralVolume(*procedural), isCT ? "CT" : "", {} };
  }
  return ReadFile(std::get<FileSource>(source), observer, mayBePreview);
}

struct TimeReader::State
{
  explicit State(const FileSource& source)
    : reader(source.path, observer)
  {
    Apply(source, this->reader);
  }

  LoadObserver ofThisTime; ///< null between the times
  const LoadObserver observer = [this](double part)
  { return !this->ofThisTime || this->ofThisTime(part); };
  QuietReader reader;
};

TimeReader::TimeReader(const FileSource& source)
  : state(std::make_unique<State>(source))
{
}

TimeReader::~TimeReader() = default;

LoadedVolume TimeReader::Read(int time, const LoadObserver& observer)
{
  QuietReader& reader = this->state->reader;
  this->state->ofThisTime = observer;
  reader->SetTimeIndex(time);
  reader->Update();
  this->state->ofThisTime = nullptr;
  reader.Check();
  LoadedVolume volume = VolumeOf(reader);
  // The reader's own image is filled anew by the next time, and must not keep the voxels alive.
  vtkNew<vtkImageData> own;
  own->ShallowCopy(volume.image);
  volume.image = own;
  reader->GetOutput()->ReleaseData();
  return volume;
}

bool MayHoldSeveralSeries(const FileSource& source)
{
  const std::filesystem::path path = source.path;
  const std::string name = vtksys::SystemTools::LowerCase(path.filename().string());
  const char* const format = vtkVolumeFileReader::GetFormatOfFile(source.path.c_str());
  const bool isArchive = format && format == std::string("archive");
  return source.series.empty() && !source.filesAreTimes &&
    (name == "dicomdir" || std::filesystem::is_directory(path) || isArchive);
}

LoadedVolume LoadLabelVolume(const SceneLabels& labels, const LoadObserver& observer)
{
  FileSource source = { labels.path, std::nullopt, labels.series };
  if (MayHoldSeveralSeries(source))
  {
    source.series = SegmentationSeries(labels.path, observer);
  }
  return ReadFile(source, observer);
}

std::vector<SeriesSummary> ListSeries(const std::string& path, const LoadObserver& observer)
{
  QuietReader reader(path, observer);
  const auto found = reader->ListDICOMSeries();
  reader.Check();
  std::vector<SeriesSummary> all;
  for (const vtkVolumeFileReader::DICOMSeries& series : found)
  {
    if (observer && !observer(1.0))
    {
      throw std::runtime_error("Reading " + path + " was stopped");
    }
    all.push_back({ series.UID, series.Description, series.Modality, series.NumberOfImages,
      MiddleOfFile(series.MiddleFile), series.FrameOfReferenceUID });
  }
  return all;
}

namespace
{

// The middle slice as a volume of its own.
vtkSmartPointer<vtkImageData> MiddleSliceOf(vtkImageData* image)
{
  int extent[6];
  image->GetExtent(extent);
  extent[4] = extent[5] = (extent[4] + extent[5] + 1) / 2;
  auto slice = vtkSmartPointer<vtkImageData>::New();
  slice->ShallowCopy(image);
  slice->Crop(extent);
  return slice;
}

}

GrayPicture MiddleSlice(vtkImageData* image)
{
  const vtkSmartPointer<vtkImageData> slice = MiddleSliceOf(image);
  const ImageStatistics statistics(slice);
  const double black = statistics.Percentile(1.0);
  const double white = std::max(statistics.Percentile(99.0), black + 1e-9);
  const int* const extent = slice->GetExtent();
  GrayPicture picture = { slice->GetDimensions()[0], slice->GetDimensions()[1], {} };
  picture.pixels.reserve(std::size_t(slice->GetNumberOfPoints()));
  for (int y = extent[2]; y <= extent[3]; ++y)
  {
    for (int x = extent[0]; x <= extent[1]; ++x)
    {
      const double value = slice->GetScalarComponentAsDouble(x, y, extent[4], 0);
      const double part = (value - black) / (white - black);
      picture.pixels.push_back(
        std::isnan(part) ? 0 : std::uint8_t(std::lround(255.0 * std::clamp(part, 0.0, 1.0))));
    }
  }
  return picture;
}

vtkSmartPointer<vtkImageData> SmallCopy(vtkImageData* image, int largestSide)
{
  std::array<int, 3> factors;
  std::array<double, 3> firstIndex;
  std::array<double, 3> spacing;
  const int* const extent = image->GetExtent();
  for (int axis = 0; axis < 3; ++axis)
  {
    const int count = extent[2 * axis + 1] - extent[2 * axis] + 1;
    factors[axis] = (count + largestSide - 1) / largestSide;
    // The first mean lies in the middle of the voxels that it replaces.
    firstIndex[axis] = extent[2 * axis] + 0.5 * (factors[axis] - 1);
    spacing[axis] = factors[axis] * image->GetSpacing()[axis];
  }
  std::array<double, 3> origin;
  image->TransformContinuousIndexToPhysicalPoint(firstIndex.data(), origin.data());

  vtkNew<vtkImageShrink3D> shrink;
  shrink->SetInputData(image);
  shrink->SetShrinkFactors(factors.data());
  shrink->Update();
  vtkImageData* const small = shrink->GetOutput();
  small->SetExtent(0, small->GetDimensions()[0] - 1, 0, small->GetDimensions()[1] - 1, 0,
    small->GetDimensions()[2] - 1);
  small->SetOrigin(origin.data());
  small->SetSpacing(spacing.data());
  small->SetDirectionMatrix(image->GetDirectionMatrix());
  // They say whether the components are colours.
  small->GetPointData()->GetScalars()->CopyComponentNames(image->GetPointData()->GetScalars());
  return small;
}

}
