#include "Readers/Dicom/FileFrames.h"

#include "Readers/Dicom/Attributes.h"
#include "Readers/Dicom/FileHeader.h"
#include "Readers/Dicom/FramePlaces.h"
#include "Readers/Dicom/Mosaic.h"

#include <vtkDICOMDictHash.h>
#include <vtkDICOMItem.h>

#include <glm/geometric.hpp>

#include <algorithm>
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

/// An attribute that is a table of numbers.
std::shared_ptr<const DicomTable<std::uint16_t>> ModalityTable(
  const DicomAttributes& attributes, bool isSigned)
{
  const vtkDICOMValue& items = attributes.Value(DC::ModalityLUTSequence);
  if (!items.IsValid() || items.GetNumberOfValues() == 0)
  {
    return nullptr;
  }
  const vtkDICOMItem& item = items.GetItem(0);
  const vtkDICOMValue& descriptor = item.Get(DC::LUTDescriptor);
  const vtkDICOMValue& data = item.Get(DC::LUTData);
  if (!descriptor.IsValid() || descriptor.GetNumberOfValues() != 3 || !data.IsValid())
  {
    return nullptr;
  }
  auto table = std::make_shared<DicomTable<std::uint16_t>>();
  const int first = descriptor.GetInt(1);
  table->first = isSigned ? std::int16_t(first) : std::uint16_t(first);
  const std::size_t promised =
    descriptor.GetInt(0) == 0 ? 65536 : std::uint16_t(descriptor.GetInt(0));
  for (std::size_t i = 0; i < std::min(promised, data.GetNumberOfValues()); ++i)
  {
    table->entries.push_back(data.GetUnsignedShort(i));
  }
  return table->entries.empty() ? nullptr : table;
}

/// A stored number of the pixels' own type that the header may contain with another sign.
double WithSignOfPixels(const DicomFile& file, double number)
{
  const double range = std::ldexp(1.0, file.bitsStored);
  const double wrapped = number - range * std::floor(number / range);
  return file.isSigned && wrapped >= 0.5 * range ? wrapped - range : wrapped;
}

void TakeValueMap(const DicomAttributes& attributes, DicomFrame& frame)
{
  const double slope = attributes.NumberOr(DC::RescaleSlope, 1.0);
  frame.slope = slope == 0.0 ? 1.0 : slope;
  frame.intercept = attributes.NumberOr(DC::RescaleIntercept, 0.0);
  if (const auto scaling = attributes.Number(DC::DoseGridScaling))
  {
    frame.slope = *scaling;
  }
  if (!frame.file->isFloat)
  {
    frame.table = ModalityTable(attributes, frame.file->isSigned);
    if (const auto padding = attributes.Number(DC::PixelPaddingValue))
    {
      const double other = attributes.NumberOr(DC::PixelPaddingRangeLimit, *padding);
      const double first = WithSignOfPixels(*frame.file, *padding);
      const double last = WithSignOfPixels(*frame.file, other);
      frame.padding = { std::min(first, last), std::max(first, last) };
    }
  }
  frame.isLossy = attributes.Text(DC::LossyImageCompression) == "01";
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
