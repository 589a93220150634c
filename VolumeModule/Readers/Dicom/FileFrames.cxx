#include "Readers/Dicom/FileFrames.h"

#include "Readers/Dicom/Attributes.h"
#include "Readers/Dicom/FileHeader.h"
#include "Readers/Dicom/FrameOrder.h"
#include "Readers/Dicom/FramePlaces.h"
#include "Readers/Dicom/Mosaic.h"
#include "Readers/Dicom/ValueMaps.h"

#include <vtkDICOMDictHash.h>

#include <array>
#include <filesystem>

namespace varimarch
{
namespace
{

/// Attributes that tell images of one place apart, in the order of DicomDifference. The first one
/// that is given counts.
const std::array<std::vector<vtkDICOMTag>, std::size_t(DicomDifference::Count)> DifferenceTags = { {
  { DC::FrameType, DC::ImageType },
  { DC::ComplexImageComponent },
  { DC::ReferencedSegmentNumber },
  {},
  { DC::EffectiveEchoTime, DC::EchoTime, DC::EchoNumbers },
  { DC::InversionTimes, DC::InversionTime },
  { DC::FlipAngle },
  { DC::DiffusionBValue },
  { DC::DiffusionGradientOrientation },
  { DC::KVP },
  { DC::TemporalPositionIndex, DC::TemporalPositionIdentifier },
  { DC::NominalCardiacTriggerDelayTime, DC::TriggerTime },
  { DC::NominalPercentageOfCardiacPhase },
  { DC::NominalPercentageOfRespiratoryPhase },
  {},
  { DC::FrameAcquisitionNumber, DC::AcquisitionNumber },
  { DC::FrameAcquisitionDateTime, DC::AcquisitionDateTime },
  { DC::ConvolutionKernel },
  { DC::StackID },
  {},
} };

/// Times of day, which count only with their dates: a scan may go on after midnight.
const struct
{
  DicomDifference difference;
  vtkDICOMTag date;
  vtkDICOMTag time;
} ClockTags[] = {
  { DicomDifference::AcquisitionTime, DC::AcquisitionDate, DC::AcquisitionTime },
  { DicomDifference::ContentTime, DC::ContentDate, DC::ContentTime },
};

/// Takes the time that the file states for a frame, in seconds, or for a slice of PET in ms.
void TakeTime(const DicomAttributes& attributes, DicomFrame& frame)
{
  constexpr double SecondsPerMs = 1e-3;
  frame.timeSeconds = attributes.Number(DC::TemporalPositionTimeOffset);
  const auto referenceMs = attributes.Number(DC::FrameReferenceTime);
  if (!frame.timeSeconds && referenceMs)
  {
    frame.timeSeconds = SecondsPerMs * *referenceMs;
  }
}

void TakeDifferences(const DicomAttributes& attributes, DicomFrame& frame)
{
  for (std::size_t i = 0; i < DifferenceTags.size(); ++i)
  {
    for (const vtkDICOMTag tag : DifferenceTags[i])
    {
      frame.differences[i] =
        frame.differences[i].empty() ? attributes.Text(tag) : frame.differences[i];
    }
  }
  for (const auto& clock : ClockTags)
  {
    constexpr std::size_t DateDigits = 8;
    std::string& moment = frame.differences[std::size_t(clock.difference)];
    const std::string date = attributes.Text(clock.date);
    const std::string time = attributes.Text(clock.time);
    const bool hasDate = date.size() == DateDigits && !time.empty();
    moment = moment.empty() ? (hasDate ? date : "") + time : moment;
    moment = moment.substr(0, moment.find_first_of("+-")); // all have one time zone
  }
}

DicomFrame FrameOf(const DicomHeader& header, int number)
{
  const DicomAttributes attributes(header.meta, number);
  DicomFrame frame;
  frame.file = header.file;
  frame.number = number;
  frame.size = { header.file->columns, header.file->rows };
  frame.instanceNumber = attributes.NumberOr(DC::InstanceNumber, 0.0);
  TakeDifferences(attributes, frame);
  TakeTime(attributes, frame);
  TakeValueMap(attributes, frame);
  frame.isLossy = attributes.Text(DC::LossyImageCompression) == "01";
  return frame;
}

/// The complete frames of a file; none of a mosaic that does not say how many slices it has.
std::vector<DicomFrame> FramesOf(const DicomHeader& header)
{
  std::vector<DicomFrame> frames;
  frames.reserve(std::size_t(header.completeFrames));
  for (int number = 0; number < header.completeFrames; ++number)
  {
    frames.push_back(FrameOf(header, number));
  }
  PlaceFrames(header.meta, frames);
  return IsMosaic(header.meta) ? MosaicTiles(header.meta, frames) : frames;
}

}

DicomContent ReadDicomContent(const std::string& path)
{
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored))
  {
    return { false, nullptr, {}, DicomFault{ path, "an existing file", "no file of this name" } };
  }
  const DicomHeader header = ReadDicomHeader(path);
  DicomContent content = { header.meta != nullptr, header.file, {}, header.fault };
  if (!header.file || header.completeFrames == 0)
  {
    return content;
  }
  if (const auto fault = FaultOfTiles(header.meta, *header.file))
  {
    content.fault = fault;
    return content;
  }
  content.frames = FramesOf(header);
  if (content.frames.empty())
  {
    content.fault = { path, "the number and direction of the slices of a Siemens mosaic", "none",
      header.file->seriesUid };
  }
  return content;
}

}
