#include "Readers/Dicom/FileFrames.h"

#include "Readers/Dicom/Attributes.h"
#include "Readers/Dicom/FileHeader.h"
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
  { DC::EffectiveEchoTime, DC::EchoTime, DC::EchoNumbers },
  { DC::DiffusionBValue },
  { DC::DiffusionGradientOrientation },
  {},
  { DC::TemporalPositionIndex, DC::TemporalPositionIdentifier },
  { DC::NominalCardiacTriggerDelayTime, DC::TriggerTime },
  { DC::NominalPercentageOfCardiacPhase },
  {},
  { DC::FrameAcquisitionNumber, DC::AcquisitionNumber },
  { DC::FrameAcquisitionDateTime, DC::AcquisitionDateTime, DC::AcquisitionTime },
  { DC::ConvolutionKernel },
  { DC::StackID },
  { DC::ContentTime },
} };

/// Frame by frame values of nuclear medicine, and the difference that they tell.
const std::pair<vtkDICOMTag, DicomDifference> NuclearVectors[] = {
  { DC::EnergyWindowVector, DicomDifference::Energy },
  { DC::RRIntervalVector, DicomDifference::CardiacPhase },
  { DC::TimeSlotVector, DicomDifference::TriggerTime },
  { DC::PhaseVector, DicomDifference::TimePoint },
  { DC::TimeSliceVector, DicomDifference::TimePoint },
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
  for (const auto& [tag, difference] : NuclearVectors)
  {
    const vtkDICOMValue& values = attributes.Value(tag);
    if (values.IsValid() && values.GetNumberOfValues() > std::size_t(frame.number))
    {
      frame.differences[std::size_t(difference)] += " " + values.GetString(frame.number);
    }
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
  content.frames = FramesOf(header);
  if (content.frames.empty())
  {
    content.fault = { path, "the number and direction of the slices of a Siemens mosaic", "none",
      header.file->seriesUid };
  }
  return content;
}

}
