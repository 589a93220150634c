#include "Readers/Dicom/SegmentFrames.h"

#include "Readers/Dicom/Attributes.h"
#include "Readers/Dicom/Pixels.h"
#include "Readers/FileError.h"
#include "Readers/NumberText.h"

#include <vtkDICOMDictHash.h>
#include <vtkDICOMItem.h>
#include <vtkMath.h>

#include <glm/common.hpp>

#include <algorithm>

namespace varimarch
{
namespace
{

/// The colour of PS3.3 C.10.7.1.1, three numbers of 16 bits.
std::optional<glm::dvec3> ColourOf(const vtkDICOMValue& lab)
{
  if (!lab.IsValid() || lab.GetNumberOfValues() != 3)
  {
    return std::nullopt;
  }
  constexpr double Largest = 65535.0;
  const auto part = [&](std::size_t i) { return lab.GetUnsignedShort(i) / Largest; };
  glm::dvec3 rgb;
  vtkMath::LabToRGB(
    100.0 * part(0), 255.0 * part(1) - 128.0, 255.0 * part(2) - 128.0, &rgb.r, &rgb.g, &rgb.b);
  return glm::clamp(rgb, 0.0, 1.0);
}

/// True for bits in the order of their bytes, which differs in the retired big-endian syntax.
bool HasSingleBits(const DicomFile& file)
{
  constexpr const char* BigEndianSyntax = "1.2.840.10008.1.2.2";
  return file.bitsAllocated == 1 && IsUncompressed(file) && file.transferSyntax != BigEndianSyntax;
}

}

SegmentationKind SegmentationKindOf(vtkDICOMMetaData* meta)
{
  const std::string type = DicomAttributes(meta).Text(DC::SegmentationType);
  return type == "FRACTIONAL" ? SegmentationKind::Fractional
    : type == "LABELMAP"      ? SegmentationKind::Labels
                              : SegmentationKind::Binary;
}

std::vector<LabelledSegment> DescribedSegments(vtkDICOMMetaData* meta)
{
  std::vector<LabelledSegment> segments;
  const vtkDICOMValue& items = DicomAttributes(meta).Value(DC::SegmentSequence);
  for (std::size_t i = 0; items.IsValid() && i < items.GetNumberOfValues(); ++i)
  {
    const vtkDICOMItem& item = items.GetItem(i);
    const vtkDICOMValue& number = item.Get(DC::SegmentNumber);
    if (number.IsValid() && number.GetVL() > 0 && number.AsInt() != 0)
    {
      segments.push_back({ number.AsInt(), item.Get(DC::SegmentLabel).AsUTF8String(),
        ColourOf(item.Get(DC::RecommendedDisplayCIELabValue)) });
    }
  }
  return segments;
}

int SegmentNumberOf(const DicomFrame& frame)
{
  const std::string& text = frame.differences[std::size_t(DicomDifference::Segment)];
  return int(NumberIn(text).value_or(0.0));
}

SegmentFrames::SegmentFrames(const DicomHeader& header)
  : header(header)
  , file(*header.file)
  , kind(SegmentationKindOf(header.meta))
{
  if (this->kind == SegmentationKind::Fractional)
  {
    this->least = 0.5 * DicomAttributes(header.meta).NumberOr(DC::MaximumFractionalValue, 255.0);
  }
  if (HasSingleBits(this->file))
  {
    this->inflated = this->file.isDeflated ? InflatedCopy(this->file.path) : nullptr;
    this->bits.open(this->inflated ? this->inflated->Path() : this->file.path, std::ios::binary);
    return;
  }
  CheckFrames(this->file.path, this->file);
  const DecodedPixels pixels = DecodePixels(this->file);
  if (pixels.fault)
  {
    FailToRead(pixels.fault->path, pixels.fault->expected, pixels.fault->found);
  }
  this->decoded = pixels.image;
}

std::vector<std::uint16_t> SegmentFrames::NumbersOf(const DicomFrame& frame)
{
  return this->decoded ? this->Decoded(frame) : this->Unpacked(frame);
}

/// Frames of single bits follow each other without gaps, the first pixel in the lowest bit of the
/// first byte (PS3.5 8.1.1).
std::vector<std::uint16_t> SegmentFrames::Unpacked(const DicomFrame& frame)
{
  const std::int64_t count = std::int64_t(this->file.rows) * this->file.columns;
  const std::int64_t firstBit = count * frame.number;
  const std::int64_t firstByte = firstBit / 8;
  std::string bytes(std::size_t((firstBit + count + 7) / 8 - firstByte), '\0');
  this->bits.seekg(this->header.pixelOffset + firstByte);
  if (!this->bits.read(bytes.data(), std::streamsize(bytes.size())))
  {
    FailToRead(this->file.path, "pixels of " + FrameName(frame), "the end of the file");
  }
  const auto number = std::uint16_t(SegmentNumberOf(frame));
  std::vector<std::uint16_t> numbers(static_cast<std::size_t>(count), 0);
  for (std::int64_t i = 0; i < count; ++i)
  {
    const std::int64_t bit = firstBit - 8 * firstByte + i;
    const bool isInside =
      (static_cast<unsigned char>(bytes[std::size_t(bit / 8)]) >> (bit % 8)) & 1;
    numbers[std::size_t(i)] = isInside ? number : 0;
  }
  return numbers;
}

std::vector<std::uint16_t> SegmentFrames::Decoded(const DicomFrame& frame) const
{
  const std::size_t count = std::size_t(this->file.rows) * std::size_t(this->file.columns);
  const auto number = std::uint16_t(SegmentNumberOf(frame));
  std::vector<std::uint16_t> numbers(count);
  const auto convert = [&](const auto* stored)
  {
    std::transform(stored, stored + count, numbers.begin(),
      [&](auto value)
      {
        return this->kind == SegmentationKind::Labels ? std::uint16_t(value)
          : double(value) >= this->least              ? number
                                                      : std::uint16_t(0);
      });
  };
  const void* const begin = this->decoded->GetScalarPointer(0, 0, frame.number);
  switch (this->decoded->GetScalarType())
  {
    vtkTemplateMacro(convert(static_cast<const VTK_TT*>(begin)));
  }
  return numbers;
}

}
