#include "Readers/Dicom/FrameOrder.h"

#include "Readers/Dicom/Attributes.h"

#include <vtkDICOMDictHash.h>
#include <vtkDICOMItem.h>

#include <glm/geometric.hpp>

#include <algorithm>

namespace varimarch
{
namespace
{

/// Values of a vector with one number for each frame, and the difference that they tell.
const std::pair<vtkDICOMTag, DicomDifference> Vectors[] = {
  { DC::EnergyWindowVector, DicomDifference::Energy },
  { DC::RRIntervalVector, DicomDifference::CardiacPhase },
  { DC::TimeSlotVector, DicomDifference::TriggerTime },
  { DC::PhaseVector, DicomDifference::TimePoint },
  { DC::TimeSliceVector, DicomDifference::TimePoint },
  { DC::DetectorVector, DicomDifference::View },
  { DC::RotationVector, DicomDifference::View },
  { DC::AngularViewVector, DicomDifference::View },
  { DC::FramePrimaryAngleVector, DicomDifference::View },
  { DC::FrameSecondaryAngleVector, DicomDifference::View },
};

/// Differences that separate images of one place. Slices of one volume may differ in the others,
/// such as the time of day.
constexpr DicomDifference DifferencesOfOnePlace[] = { DicomDifference::ImageType,
  DicomDifference::Component, DicomDifference::View, DicomDifference::Echo,
  DicomDifference::InversionTime, DicomDifference::FlipAngle, DicomDifference::DiffusionWeighting,
  DicomDifference::DiffusionDirection, DicomDifference::Energy, DicomDifference::TimePoint,
  DicomDifference::TriggerTime, DicomDifference::CardiacPhase, DicomDifference::RespiratoryPhase };

/// The numbers of a vector; empty unless there is one for each frame of the file.
std::vector<double> VectorOf(const DicomAttributes& attributes, vtkDICOMTag tag, int frameCount)
{
  const vtkDICOMValue& value = attributes.Value(tag);
  std::vector<double> numbers;
  if (value.IsValid() && value.GetNumberOfValues() == std::size_t(frameCount))
  {
    numbers.resize(std::size_t(frameCount));
    value.GetValues(numbers.data(), numbers.size());
  }
  return numbers;
}

template <class Value>
bool Vary(const std::vector<Value>& values)
{
  return std::any_of(
    values.begin(), values.end(), [&](const Value& value) { return value != values.front(); });
}

/// The place of the slice in the indices of dimensions; empty if they do not count slices.
std::optional<std::size_t> SliceDimension(const DicomAttributes& attributes)
{
  const vtkDICOMTag ofSlices[] = { DC::InStackPositionNumber, DC::ImagePositionPatient,
    DC::ImagePositionVolume, DC::PlanePositionSequence, DC::PlanePositionVolumeSequence };
  const vtkDICOMValue& items = attributes.Value(DC::DimensionIndexSequence);
  for (std::size_t i = 0; items.IsValid() && i < items.GetNumberOfValues(); ++i)
  {
    const vtkDICOMValue& pointer = items.GetItem(i).Get(DC::DimensionIndexPointer);
    if (pointer.IsValid() && pointer.GetNumberOfValues() > 0 &&
      std::find(std::begin(ofSlices), std::end(ofSlices), pointer.GetTag(0)) != std::end(ofSlices))
    {
      return i;
    }
  }
  return std::nullopt;
}

/// The numbers of the frames' slices; empty if the file does not tell them, or gives one to all.
std::vector<double> SliceNumbers(vtkDICOMMetaData* meta, const std::vector<DicomFrame>& frames)
{
  const DicomAttributes attributes(meta);
  std::vector<double> numbers =
    VectorOf(attributes, DC::SliceVector, frames.front().file->frameCount);
  const auto dimension = SliceDimension(attributes);
  for (std::size_t i = 0; numbers.size() == i && i < frames.size(); ++i)
  {
    const DicomAttributes ofFrame(meta, frames[i].number);
    const auto inStack = ofFrame.Number(DC::InStackPositionNumber);
    const vtkDICOMValue& indices = ofFrame.Value(DC::DimensionIndexValues);
    const bool isCounted =
      dimension && indices.IsValid() && indices.GetNumberOfValues() > *dimension;
    if (inStack || isCounted)
    {
      numbers.push_back(inStack ? *inStack : indices.GetDouble(*dimension));
    }
  }
  return numbers.size() >= frames.size() && Vary(numbers) ? numbers : std::vector<double>();
}

/// True if the file says that its frames differ in something else than their place.
bool DifferOtherwise(const std::vector<DicomFrame>& frames)
{
  const auto varies = [&](DicomDifference difference)
  {
    const auto i = std::size_t(difference);
    return std::any_of(frames.begin(), frames.end(),
      [&](const DicomFrame& frame)
      { return frame.differences[i] != frames.front().differences[i]; });
  };
  return std::any_of(std::begin(DifferencesOfOnePlace), std::end(DifferencesOfOnePlace), varies) ||
    std::any_of(frames.begin(), frames.end(),
      [&](const DicomFrame& frame) { return frame.timeSeconds != frames.front().timeSeconds; });
}

/// True for frames that a file describes as a film. Tomographs give slices a frame time, too.
bool IsFilm(const DicomAttributes& attributes, const DicomFile& file)
{
  const bool hasFrameTime =
    attributes.Value(DC::FrameTime).IsValid() || attributes.Value(DC::FrameTimeVector).IsValid();
  return hasFrameTime && file.modality != "CT" && file.modality != "PT";
}

/// Signs of the directions that offsets of doses count in: along z for positions, along the normal
/// for distances from the first frame (PS3.3 C.8.8.3.2).
double DoseSign(const DicomFrame& frame, double firstOffset)
{
  const bool isPosition = firstOffset != 0.0;
  return isPosition && frame.axes && glm::cross((*frame.axes)[0], (*frame.axes)[1]).z < 0.0 ? -1.0
                                                                                            : 1.0;
}

/// The numbers less the first of them, times a factor.
std::vector<double> FromFirst(const std::vector<double>& numbers, double factor)
{
  std::vector<double> offsets;
  for (const double number : numbers)
  {
    offsets.push_back(factor * (number - numbers.front()));
  }
  return offsets;
}

}

void TakeVectors(vtkDICOMMetaData* meta, std::vector<DicomFrame>& frames)
{
  const DicomAttributes attributes(meta);
  for (const auto& [tag, difference] : Vectors)
  {
    const vtkDICOMValue& values = attributes.Value(tag);
    const bool isView = difference == DicomDifference::View;
    const std::vector<double> numbers = frames.empty()
      ? std::vector<double>()
      : VectorOf(attributes, tag, frames[0].file->frameCount);
    for (DicomFrame& frame : frames)
    {
      if (!numbers.empty() && (!isView || Vary(numbers)))
      {
        frame.differences[std::size_t(difference)] +=
          " " + values.GetString(std::size_t(frame.number));
      }
    }
  }
}

std::vector<double> OffsetsMm(vtkDICOMMetaData* meta, const std::vector<DicomFrame>& frames)
{
  const DicomAttributes attributes(meta);
  const DicomFrame& first = frames.front();
  const int count = first.file->frameCount;
  const double distanceMm = first.distanceMm.value_or(1.0);
  const std::vector<double> dose = VectorOf(attributes, DC::GridFrameOffsetVector, count);
  if (!dose.empty())
  {
    return FromFirst(dose, DoseSign(first, dose.front()));
  }
  const std::vector<double> locations = VectorOf(attributes, DC::SliceLocationVector, count);
  if (Vary(locations))
  {
    return FromFirst(locations, 1.0);
  }
  const std::vector<double> slices = SliceNumbers(meta, frames);
  if (!slices.empty())
  {
    return FromFirst(slices, distanceMm);
  }
  if (DifferOtherwise(frames) || IsFilm(attributes, *first.file))
  {
    return {};
  }
  std::vector<double> offsets;
  const bool isTomography = first.file->modality == "CT" || first.file->modality == "PT";
  for (int i = 0; (first.distanceMm || isTomography) && i < count; ++i)
  {
    offsets.push_back(i * distanceMm);
  }
  return offsets;
}

std::optional<DicomFault> FaultOfTiles(vtkDICOMMetaData* meta, const DicomFile& file)
{
  const DicomAttributes attributes(meta);
  const double columns = attributes.NumberOr(DC::TotalPixelMatrixColumns, 0.0);
  const double rows = attributes.NumberOr(DC::TotalPixelMatrixRows, 0.0);
  if (columns <= file.columns && rows <= file.rows)
  {
    return std::nullopt;
  }
  return DicomFault{ file.path, "slices of a volume",
    "tiles of a flat slide of " + std::to_string(std::int64_t(columns)) + " x " +
      std::to_string(std::int64_t(rows)) + " pixels",
    file.seriesUid };
}

}
