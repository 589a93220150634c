#include "Readers/Dicom/FileFrames.h"

#include "Readers/Dicom/Attributes.h"
#include "Readers/Dicom/DicomFrame.h"
#include "Readers/Dicom/FileHeader.h"
#include "Readers/Dicom/FrameOrder.h"
#include "Readers/Parsing/NumberText.h"

#include <vtkDICOMDictHash.h>
#include <vtkDICOMItem.h>
#include <vtkDICOMMetaData.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>

namespace varimarch
{
namespace
{

/// The entries of a table. Those of 8 bits may stand in pairs in words, the first in the lower byte
/// (PS3.3 C.11.1.1.1).
std::vector<std::uint16_t> EntriesOf(const vtkDICOMValue& descriptor, const vtkDICOMValue& data)
{
  constexpr int ByteBits = 8;
  const std::size_t promised =
    descriptor.GetInt(0) == 0 ? 65536 : std::uint16_t(descriptor.GetInt(0));
  const std::size_t words = data.GetNumberOfValues();
  const bool arePairs = descriptor.GetInt(2) <= ByteBits && words < promised;
  std::vector<std::uint16_t> entries;
  for (std::size_t i = 0; i < std::min(promised, arePairs ? 2 * words : words); ++i)
  {
    const std::uint16_t word = data.GetUnsignedShort(arePairs ? i / 2 : i);
    entries.push_back(!arePairs ? word : std::uint16_t(i % 2 ? word >> ByteBits : word & 0xff));
  }
  return entries;
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
  table->entries = EntriesOf(descriptor, data);
  return table->entries.empty() ? nullptr : table;
}

/// A stored number of the pixels' own type that the header may contain with another sign.
double WithSignOfPixels(const DicomFile& file, double number)
{
  const double range = std::ldexp(1.0, file.bitsStored);
  const double wrapped = number - range * std::floor(number / range);
  return file.isSigned && wrapped >= 0.5 * range ? wrapped - range : wrapped;
}

/// A map to physical quantities beside, or in place of, that of the modality (PS3.3 C.7.6.16.2.11).
struct RealWorldMap
{
  std::string unit; ///< or its label; may be empty
  std::optional<double> slope;
  double intercept = 0.0;
};

/// The first linear map of a frame, or else its first map.
std::optional<RealWorldMap> RealWorldMapOf(const DicomAttributes& attributes)
{
  const vtkDICOMValue& items = attributes.Value(DC::RealWorldValueMappingSequence);
  std::optional<RealWorldMap> found;
  for (std::size_t i = 0; items.IsValid() && i < items.GetNumberOfValues(); ++i)
  {
    const vtkDICOMItem& item = items.GetItem(i);
    const vtkDICOMValue& slope = item.Get(DC::RealWorldValueSlope);
    const vtkDICOMValue& units = item.Get(DC::MeasurementUnitsCodeSequence);
    RealWorldMap map;
    map.unit = units.IsValid() && units.GetNumberOfValues() > 0
      ? units.GetItem(0).Get(DC::CodeValue).AsUTF8String()
      : item.Get(DC::LUTLabel).AsUTF8String();
    if (slope.IsValid() && slope.GetVL() > 0 && std::isfinite(slope.AsDouble()))
    {
      const vtkDICOMValue& intercept = item.Get(DC::RealWorldValueIntercept);
      map.slope = slope.AsDouble();
      map.intercept = intercept.IsValid() && intercept.GetVL() > 0 ? intercept.AsDouble() : 0.0;
    }
    if (!found || (map.slope && !found->slope))
    {
      found = map;
    }
  }
  return found;
}

/// Applies a real-world map to a frame without another one, or names it.
void TakeRealWorldMap(const DicomAttributes& attributes, bool hasOther, DicomFrame& frame)
{
  const auto map = RealWorldMapOf(attributes);
  if (!map)
  {
    return;
  }
  const bool isApplied = !hasOther && map->slope && *map->slope != 0.0;
  if (isApplied)
  {
    frame.slope = *map->slope;
    frame.intercept = map->intercept;
    frame.isRealWorld = true;
    return;
  }
  const bool isSame =
    map->slope && !frame.table && frame.slope == *map->slope && frame.intercept == map->intercept;
  frame.otherMap = isSame ? "" : map->unit.empty() ? "another quantity" : map->unit;
}

/// Takes the map from stored to physical values of a frame: the modality's slope and intercept, or
/// its table, or the scale of a dose; a real-world value map if the file has none of these. A
/// real-world map that is not applied is named. Takes the padding too.
void TakeValueMap(const DicomAttributes& attributes, DicomFrame& frame)
{
  const double slope = attributes.NumberOr(DC::RescaleSlope, 1.0);
  frame.slope = slope == 0.0 ? 1.0 : slope;
  frame.intercept = attributes.NumberOr(DC::RescaleIntercept, 0.0);
  const auto scaling = attributes.Number(DC::DoseGridScaling);
  if (scaling)
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
  const bool hasOther = frame.table || scaling || attributes.Number(DC::RescaleSlope) ||
    attributes.Number(DC::RescaleIntercept);
  TakeRealWorldMap(attributes, hasOther, frame);
}

std::optional<glm::dmat2x3> AxesOf(const DicomAttributes& attributes)
{
  const vtkDICOMTagPath detector(DC::DetectorInformationSequence, 0, DC::ImageOrientationPatient);
  auto axes = attributes.Numbers<glm::dmat2x3>(DC::ImageOrientationPatient);
  axes = axes ? axes : attributes.Numbers<glm::dmat2x3>(DC::ImageOrientationVolume);
  axes = axes ? axes : attributes.Numbers<glm::dmat2x3>(detector);
  if (!axes || glm::length(glm::cross((*axes)[0], (*axes)[1])) < 1e-6)
  {
    return std::nullopt;
  }
  return glm::dmat2x3(glm::normalize((*axes)[0]), glm::normalize((*axes)[1]));
}

std::optional<glm::dvec3> PositionOf(const DicomAttributes& attributes)
{
  const vtkDICOMTagPath detector(DC::DetectorInformationSequence, 0, DC::ImagePositionPatient);
  auto position = attributes.Numbers<glm::dvec3>(DC::ImagePositionPatient);
  position = position ? position : attributes.Numbers<glm::dvec3>(DC::ImagePositionVolume);
  return position ? position : attributes.Numbers<glm::dvec3>(detector);
}

/// Size of the pixels of the first region of an ultrasound image that is measured in cm along both
/// axes: that of a picture of tissue, if there is one, as other regions show traces over time.
std::optional<glm::dvec2> RegionPixelMm(const DicomAttributes& attributes)
{
  constexpr double UnitIsCm = 3.0;
  constexpr double MmPerCm = 10.0;
  constexpr double IsTissue = 1.0;
  const vtkDICOMValue& regions = attributes.Value(DC::SequenceOfUltrasoundRegions);
  std::optional<glm::dvec2> pixelMm;
  for (std::size_t i = 0; regions.IsValid() && i < regions.GetNumberOfValues(); ++i)
  {
    const auto number = [&](vtkDICOMTag tag)
    {
      return attributes.Number(
        vtkDICOMTagPath(DC::SequenceOfUltrasoundRegions, static_cast<unsigned int>(i), tag));
    };
    const auto x = number(DC::PhysicalDeltaX);
    const auto y = number(DC::PhysicalDeltaY);
    const bool isLength = number(DC::PhysicalUnitsXDirection) == UnitIsCm &&
      number(DC::PhysicalUnitsYDirection) == UnitIsCm;
    const bool isTissue = number(DC::RegionSpatialFormat) == IsTissue;
    if (x && y && isLength && (!pixelMm || isTissue))
    {
      pixelMm = MmPerCm * glm::abs(glm::dvec2(*x, *y));
      if (isTissue)
      {
        break;
      }
    }
  }
  return pixelMm;
}

/// Distances of columns and of rows, from the attribute that the kind of file has.
std::optional<glm::dvec2> PixelMmOf(const DicomAttributes& attributes)
{
  const auto isPositive = [](const std::optional<glm::dvec2>& mm)
  { return mm && mm->x > 0.0 && mm->y > 0.0; };
  for (const vtkDICOMTag tag :
    { DC::PixelSpacing, DC::ImagerPixelSpacing, DC::NominalScannedPixelSpacing })
  {
    const auto rowsAndColumnsMm = attributes.Numbers<glm::dvec2>(tag);
    if (isPositive(rowsAndColumnsMm))
    {
      return glm::dvec2(rowsAndColumnsMm->y, rowsAndColumnsMm->x);
    }
  }
  const auto regionMm = RegionPixelMm(attributes);
  return isPositive(regionMm) ? regionMm : std::nullopt;
}

void PlaceFrame(const DicomAttributes& attributes, DicomFrame& frame)
{
  frame.axes = AxesOf(attributes);
  frame.positionMm = PositionOf(attributes);
  frame.isPatientSpace = !attributes.Value(DC::ImagePositionVolume).IsValid();
  frame.pixelMm = PixelMmOf(attributes);
  const auto aspect = attributes.Numbers<glm::dvec2>(DC::PixelAspectRatio);
  frame.pixelAspect = aspect && aspect->x > 0.0 && aspect->y > 0.0 ? aspect->y / aspect->x : 1.0;
  frame.heightMm = attributes.Number(DC::SliceLocation);
  const auto distance = attributes.Number(DC::SpacingBetweenSlices);
  const auto thickness = attributes.Number(DC::SliceThickness);
  frame.isDistanceThickness = !(distance && *distance != 0.0);
  const auto stated = frame.isDistanceThickness ? thickness : distance;
  if (stated && *stated != 0.0)
  {
    frame.distanceMm = *stated;
  }
}

bool HavePlacesOfTheirOwn(vtkDICOMMetaData* meta)
{
  const vtkDICOMValue& groups = meta->Get(DC::PerFrameFunctionalGroupsSequence);
  if (!groups.IsValid() || groups.GetNumberOfValues() == 0)
  {
    return false;
  }
  const DicomAttributes shared(meta, -1);
  const DicomAttributes first(meta, 0);
  return PositionOf(first).has_value() && !PositionOf(shared).has_value();
}

void Stack(const std::vector<double>& offsetsMm, std::vector<DicomFrame>& frames)
{
  for (DicomFrame& frame : frames)
  {
    const double offsetMm = offsetsMm[std::size_t(frame.number)];
    frame.heightMm = offsetMm;
    if (frame.positionMm && frame.axes)
    {
      *frame.positionMm += offsetMm * glm::cross((*frame.axes)[0], (*frame.axes)[1]);
    }
  }
}

/// Makes frames at one place follow each other in time. The times between them are all alike, or
/// each is that since the frame before (PS3.3 C.7.6.5).
void MakeFilm(const DicomAttributes& attributes, std::vector<DicomFrame>& frames)
{
  constexpr double SecondsPerMs = 1e-3;
  const vtkDICOMValue& stepsMs = attributes.Value(DC::FrameTimeVector);
  const auto stepMs = attributes.Number(DC::FrameTime);
  const bool hasSteps = stepsMs.IsValid() &&
    stepsMs.GetNumberOfValues() == std::size_t(frames.front().file->frameCount);
  double seconds = 0.0;
  for (DicomFrame& frame : frames)
  {
    frame.heightMm = 0.0;
    frame.sharesPlace = true;
    frame.differences[std::size_t(DicomDifference::FrameNumber)] = std::to_string(frame.number + 1);
    if (hasSteps)
    {
      seconds += SecondsPerMs * stepsMs.GetDouble(std::size_t(frame.number));
      frame.timeSeconds = seconds;
    }
    else if (stepMs)
    {
      frame.timeSeconds = SecondsPerMs * *stepMs * frame.number;
    }
  }
}

bool IsRadiograph(const DicomFrame& frame)
{
  constexpr const char* Radiographs[] = { "CR", "DX", "MG", "IO", "PX", "RG" };
  const std::string& modality = frame.file->modality;
  return frame.file->frameCount == 1 && !frame.positionMm &&
    std::find(std::begin(Radiographs), std::end(Radiographs), modality) != std::end(Radiographs);
}

/// Makes a radiograph a view by its side, its direction and its number.
void MakeView(const DicomAttributes& attributes, DicomFrame& frame)
{
  std::string& view = frame.differences[std::size_t(DicomDifference::View)];
  for (const vtkDICOMTag tag : { DC::ImageLaterality, DC::ViewPosition, DC::InstanceNumber })
  {
    const std::string text = attributes.Text(tag);
    view += (view.empty() || text.empty() ? "" : " ") + text;
  }
  frame.heightMm = 0.0;
  frame.sharesPlace = true;
}

/// Sets the positions, directions and distances of pixels and slices of a file's frames. Frames
/// without positions of their own are stacked along their normal as OffsetsMm says, or else are
/// images of one place. Radiographs without positions are views, not slices.
/// @param frames  the first frames of the file, in order
void PlaceFrames(vtkDICOMMetaData* meta, std::vector<DicomFrame>& frames)
{
  for (DicomFrame& frame : frames)
  {
    const DicomAttributes attributes(meta, frame.number);
    PlaceFrame(attributes, frame);
    if (IsRadiograph(frame))
    {
      MakeView(attributes, frame);
    }
  }
  TakeVectors(meta, frames);
  if (frames.empty() || frames.front().file->frameCount == 1 || HavePlacesOfTheirOwn(meta))
  {
    return;
  }
  const std::vector<double> offsetsMm = OffsetsMm(meta, frames);
  if (!offsetsMm.empty())
  {
    Stack(offsetsMm, frames);
    return;
  }
  MakeFilm(DicomAttributes(meta), frames);
}

/// Siemens' private header, which begins with "SV10" (nibabel, "Siemens format DICOM with CSA
/// header"). GDCM reads it too, but ends the program if it is malformed.
class SiemensHeader
{
public:
  explicit SiemensHeader(std::string bytes)
    : bytes(std::move(bytes))
  {
  }

  /// Values of an attribute; empty if it is absent.
  std::vector<std::string> Values(const std::string& name)
  {
    constexpr std::size_t SignatureSize = 8;
    this->place = SignatureSize;
    const std::uint32_t attributes = this->bytes.compare(0, 4, "SV10") == 0 ? this->Number() : 0;
    this->Number();
    for (std::uint32_t i = 0; i < attributes && this->place < this->bytes.size(); ++i)
    {
      const bool isIt = this->Text(64) == name;
      const std::vector<std::string> values = this->NextValues();
      if (isIt)
      {
        return values;
      }
    }
    return {};
  }

private:
  /// The values of the attribute whose name was just read. Some are blank.
  std::vector<std::string> NextValues()
  {
    std::vector<std::string> values;
    this->place += 3 * sizeof(std::uint32_t); // multiplicity and type
    const std::uint32_t count = this->Number();
    this->Number();
    for (std::uint32_t i = 0; i < count && this->place < this->bytes.size(); ++i)
    {
      this->Number();
      const std::uint32_t length = this->Number();
      this->place += 2 * sizeof(std::uint32_t);
      values.push_back(this->Text(length));
      this->place += (4 - length % 4) % 4;
    }
    return values;
  }

  std::uint32_t Number()
  {
    std::uint32_t number = 0;
    if (this->place + sizeof(number) <= this->bytes.size())
    {
      std::memcpy(&number, this->bytes.data() + this->place, sizeof(number));
    }
    this->place += sizeof(number);
    return number;
  }

  std::string Text(std::size_t length)
  {
    const std::string text =
      this->place < this->bytes.size() ? this->bytes.substr(this->place, length) : "";
    this->place += length;
    return text.substr(0, text.find('\0'));
  }

  std::string bytes;
  std::size_t place = 0;
};

SiemensHeader HeaderOf(vtkDICOMMetaData* meta)
{
  const vtkDICOMTag tag =
    meta->ResolvePrivateTag(vtkDICOMTag(0x0029, 0x0010), "SIEMENS CSA HEADER");
  const vtkDICOMValue& value = meta->Get(tag);
  const unsigned char* const begin = value.IsValid() ? value.GetUnsignedCharData() : nullptr;
  return SiemensHeader(begin ? std::string(begin, begin + value.GetVL()) : std::string());
}

/// Number and order of the slices of a mosaic.
struct Tiling
{
  int count = 0;             ///< 0 if unknown
  glm::dvec3 direction = {}; ///< unit vector from a slice to the next
};

Tiling TilingOf(vtkDICOMMetaData* meta)
{
  SiemensHeader header = HeaderOf(meta);
  const std::vector<std::string> count = header.Values("NumberOfImagesInMosaic");
  const std::vector<std::string> normal = header.Values("SliceNormalVector");
  Tiling tiling;
  if (!count.empty() && normal.size() >= 3)
  {
    constexpr double MostTiles = 10000.0;
    tiling.count = int(std::clamp(NumberIn(count[0]).value_or(0.0), 0.0, MostTiles));
    for (int axis = 0; axis < 3; ++axis)
    {
      tiling.direction[axis] = NumberIn(normal[std::size_t(axis)]).value_or(0.0);
    }
  }
  return tiling;
}

/// True for a picture of Siemens MR scanners whose tiles are the slices of a volume.
bool IsMosaic(vtkDICOMMetaData* meta)
{
  return DicomAttributes(meta).Text(DC::ImageType).find("MOSAIC") != std::string::npos;
}

/// The slices of a mosaic, as tiles of its frames; none if the file does not say how many tiles
/// there are and in which direction they follow each other.
///
/// The position that the file states is that of the first pixel of an image of the mosaic's size
/// around the centre of the first tile (nibabel, "Siemens mosaic format").
std::vector<DicomFrame> MosaicTiles(vtkDICOMMetaData* meta, const std::vector<DicomFrame>& frames)
{
  const Tiling tiling = TilingOf(meta);
  const int tilesPerRow = std::max(1, int(std::ceil(std::sqrt(double(tiling.count)))));
  std::vector<DicomFrame> tiles;
  for (const DicomFrame& frame : frames)
  {
    DicomFrame tile = frame;
    tile.size = frame.size / tilesPerRow;
    tile.heightMm.reset();
    for (int i = 0; i < tiling.count; ++i)
    {
      tile.firstPixel = glm::ivec2(i % tilesPerRow, i / tilesPerRow) * tile.size;
      if (frame.positionMm && frame.axes && frame.pixelMm)
      {
        const glm::dvec2 borderMm = 0.5 * glm::dvec2(frame.size - tile.size) * *frame.pixelMm;
        tile.positionMm = *frame.positionMm + *frame.axes * borderMm +
          double(i) * frame.distanceMm.value_or(1.0) * tiling.direction;
      }
      tiles.push_back(tile);
    }
  }
  return tiles;
}

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
