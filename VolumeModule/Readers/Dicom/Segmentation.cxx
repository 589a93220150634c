#include "Readers/Dicom/Segmentation.h"

#include "Readers/Dicom/Attributes.h"
#include "Readers/Dicom/FileFrames.h"
#include "Readers/Dicom/FileHeader.h"
#include "Readers/Dicom/GdcmCopy.h"
#include "Readers/Dicom/Pixels.h"
#include "Readers/FileError.h"
#include "Readers/ImageGeometry.h"
#include "Readers/Parsing/NumberText.h"
#include "Readers/SegmentOverlap.h"
#include "Readers/VolumeFile.h"
#include "Readers/VoxelLayout.h"

#include <vtkDICOMDictHash.h>
#include <vtkDICOMItem.h>
#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkSmartPointer.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <map>
#include <vector>

namespace varimarch
{
namespace
{

enum class SegmentationKind
{
  Binary,     ///< 1 where the segment of the frame is
  Fractional, ///< the part of the voxel that is in the segment, or its probability
  Labels      ///< the number of the segment
};

/// The pixels of a segmentation frame by frame, as numbers of segments. Masks of single bits are
/// unpacked as they are needed: those of all segments would need far more memory than the labels.
class SegmentFrames
{
public:
  /// @param header  the header of a file with pixels; must outlive this object
  /// @throws std::runtime_error if the pixels cannot be decoded
  explicit SegmentFrames(const DicomHeader& header);

  /// The numbers of the segments of a frame's pixels, row by row; 0 for none.
  /// @throws std::runtime_error if the file cannot be read
  std::vector<std::uint16_t> NumbersOf(const DicomFrame& frame);

private:
  std::vector<std::uint16_t> Unpacked(const DicomFrame& frame);
  std::vector<std::uint16_t> Decoded(const DicomFrame& frame) const;

  const DicomHeader& header;
  const DicomFile& file;
  std::shared_ptr<const ScratchFile> inflated; ///< a copy of the file, if it is deflated
  SegmentationKind kind;
  double least = 1.0;                    ///< smallest stored value inside a segment
  std::ifstream bits;                    ///< the file, if its pixels are single bits
  vtkSmartPointer<vtkImageData> decoded; ///< all frames, if its pixels are larger
};

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

/// The kind that a segmentation says it is; binary if it does not say.
SegmentationKind SegmentationKindOf(vtkDICOMMetaData* meta)
{
  const std::string type = DicomAttributes(meta).Text(DC::SegmentationType);
  return type == "FRACTIONAL" ? SegmentationKind::Fractional
    : type == "LABELMAP"      ? SegmentationKind::Labels
                              : SegmentationKind::Binary;
}

/// The segments that a segmentation describes.
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

/// Number of the segment of a frame; 0 if it does not say.
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

/// The grid that the frames of a segmentation lie on, and the slices that each frame fills.
struct FrameGrid
{
  ImageGeometry geometry;
  std::vector<std::vector<std::int64_t>> slices;
  std::int64_t sliceCount = 1;
};

bool IsParallel(const DicomFrame& a, const DicomFrame& b)
{
  constexpr double LargestTurn = 0.001;
  return a.size == b.size && glm::distance((*a.axes)[0], (*b.axes)[0]) < LargestTurn &&
    glm::distance((*a.axes)[1], (*b.axes)[1]) < LargestTurn &&
    glm::distance(*a.pixelMm, *b.pixelMm) < LargestTurn * glm::length(*a.pixelMm);
}

void CheckPlaces(const std::string& path, const std::vector<DicomFrame>& frames)
{
  for (const DicomFrame& frame : frames)
  {
    if (!frame.positionMm || !frame.axes || !frame.pixelMm)
    {
      FailToRead(path,
        "the position, orientation and pixel spacing of each frame of a segmentation",
        "none for " + FrameName(frame));
    }
    if (!IsParallel(frame, frames.front()))
    {
      FailToRead(path, "frames of one size and direction in a segmentation",
        "another one for " + FrameName(frame));
    }
  }
}

/// The planes that frames lie in.
struct FramePlanes
{
  std::vector<double> heightsMm; ///< along the normal, in ascending order
  double distanceMm = 1.0;       ///< distance of the slices of the grid
  bool isStated = false;         ///< true if the file states that slices have this distance

  double GapMm(std::size_t i) const { return this->heightsMm[i + 1] - this->heightsMm[i]; }
  std::size_t GapCount() const { return this->heightsMm.size() - 1; }
  std::int64_t SliceOf(double heightMm) const
  {
    return std::int64_t(std::llround((heightMm - this->heightsMm.front()) / this->distanceMm));
  }
};

constexpr double LargestDifference = 0.05; // between distances that count as equal, in parts

bool AreEqual(double aMm, double bMm)
{
  return std::abs(aMm - bMm) <= LargestDifference * bMm;
}

/// Takes the distance of the slices: the stated one, or else the thickness, if the frames fit to
/// it; else the smallest that occurs, for most segments have no frame on some slices.
void TakeDistance(const DicomFrame& first, FramePlanes& planes)
{
  const double statedMm = std::abs(first.distanceMm.value_or(0.0));
  if (planes.GapCount() == 0)
  {
    planes.distanceMm = statedMm > 0.0 ? statedMm : 1.0;
    return;
  }
  double smallestMm = planes.GapMm(0);
  for (std::size_t i = 1; i < planes.GapCount(); ++i)
  {
    smallestMm = std::min(smallestMm, planes.GapMm(i));
  }
  const double steps = statedMm > 0.0 ? smallestMm / statedMm : 0.0;
  const bool fits =
    std::lround(steps) > 0 && std::abs(steps - double(std::lround(steps))) < LargestDifference;
  planes.distanceMm = fits ? smallestMm / double(std::lround(steps)) : smallestMm;
  planes.isStated = fits && !first.isDistanceThickness;
}

FramePlanes PlanesOf(std::vector<double> heightsMm, const DicomFrame& first)
{
  constexpr double SamePlaceMm = 1e-3;
  std::sort(heightsMm.begin(), heightsMm.end());
  FramePlanes planes;
  for (const double heightMm : heightsMm)
  {
    if (planes.heightsMm.empty() || heightMm - planes.heightsMm.back() > SamePlaceMm)
    {
      planes.heightsMm.push_back(heightMm);
    }
  }
  TakeDistance(first, planes);
  return planes;
}

/// True if frames follow each other at the distance of the grid somewhere.
bool HasFineStack(const FramePlanes& planes)
{
  for (std::size_t i = 1; i < planes.GapCount(); ++i)
  {
    if (AreEqual(planes.GapMm(i - 1), planes.distanceMm) &&
      AreEqual(planes.GapMm(i), planes.distanceMm))
    {
      return true;
    }
  }
  return false;
}

/// True if a gap is the distance of the slices of the scan at that place, instead of a gap in a
/// segment: several such gaps follow each other, while slices are nearer elsewhere.
bool IsCoarse(const FramePlanes& planes, std::size_t gap)
{
  const double gapMm = planes.GapMm(gap);
  const bool isRepeated = (gap > 0 && AreEqual(planes.GapMm(gap - 1), gapMm)) ||
    (gap + 1 < planes.GapCount() && AreEqual(planes.GapMm(gap + 1), gapMm));
  return isRepeated && !planes.isStated && gapMm > 1.5 * planes.distanceMm;
}

/// The slices without a frame that belong to the nearest plane, by the slice of this plane.
std::map<std::int64_t, std::vector<std::int64_t>> BridgedSlices(
  const FramePlanes& planes, std::vector<std::string>& warnings)
{
  std::map<std::int64_t, std::vector<std::int64_t>> bridged;
  const bool hasFineStack = HasFineStack(planes);
  for (std::size_t gap = 0; hasFineStack && gap < planes.GapCount(); ++gap)
  {
    const std::int64_t lower = planes.SliceOf(planes.heightsMm[gap]);
    const std::int64_t upper = planes.SliceOf(planes.heightsMm[gap + 1]);
    for (std::int64_t slice = lower + 1; IsCoarse(planes, gap) && slice < upper; ++slice)
    {
      bridged[slice - lower <= upper - slice ? lower : upper].push_back(slice);
    }
  }
  if (!bridged.empty())
  {
    warnings.emplace_back("The frames of the segmentation lie at two distances, as the slices of "
                          "its scan do; each was taken to reach half way to the next.");
  }
  return bridged;
}

/// Warns of frames that were moved, and of a thickness that stands in for an unknown distance.
void WarnOfPlanes(const FramePlanes& planes, std::vector<std::string>& warnings)
{
  constexpr double LargestOffset = 0.1; // part of the distance of two slices
  double farthest = 0.0;
  bool areApart = planes.GapCount() > 0 && !planes.isStated;
  for (std::size_t i = 0; i < planes.heightsMm.size(); ++i)
  {
    const double slice = (planes.heightsMm[i] - planes.heightsMm.front()) / planes.distanceMm;
    farthest = std::max(farthest, std::abs(slice - std::round(slice)));
    areApart = areApart &&
      (i == planes.GapCount() || planes.GapMm(i) > (1.0 + LargestDifference) * planes.distanceMm);
  }
  if (farthest > LargestOffset)
  {
    warnings.emplace_back("The frames of the segmentation lie at uneven distances; each was moved "
                          "to the nearest of the even slices.");
  }
  if (areApart)
  {
    warnings.emplace_back("The file does not say how far apart the slices of the segmentation "
                          "are; each was taken to be as thick as stated, with nothing between.");
  }
}

FrameGrid GridOf(const std::vector<DicomFrame>& frames, std::vector<std::string>& warnings)
{
  const DicomFrame& first = frames.front();
  const glm::dvec3 normal = glm::normalize(glm::cross((*first.axes)[0], (*first.axes)[1]));
  std::vector<double> heightsMm;
  for (const DicomFrame& frame : frames)
  {
    heightsMm.push_back(glm::dot(*frame.positionMm, normal));
  }
  const FramePlanes planes = PlanesOf(heightsMm, first);
  WarnOfPlanes(planes, warnings);
  const auto bridged = BridgedSlices(planes, warnings);
  FrameGrid grid;
  for (const double heightMm : heightsMm)
  {
    const std::int64_t slice = planes.SliceOf(heightMm);
    grid.slices.push_back({ slice });
    if (const auto others = bridged.find(slice); others != bridged.end())
    {
      grid.slices.back().insert(
        grid.slices.back().end(), others->second.begin(), others->second.end());
    }
    grid.sliceCount = std::max(grid.sliceCount, slice + 1);
  }
  // Frames of a tilted gantry are displaced along their rows or columns too.
  const auto [lowest, highest] = std::minmax_element(heightsMm.begin(), heightsMm.end());
  const glm::dvec3 lowestMm = *frames[std::size_t(lowest - heightsMm.begin())].positionMm;
  const glm::dvec3 highestMm = *frames[std::size_t(highest - heightsMm.begin())].positionMm;
  const glm::dvec3 stepMm = grid.sliceCount > 1
    ? (highestMm - lowestMm) / double(grid.sliceCount - 1)
    : normal * planes.distanceMm;
  grid.geometry.originMm = lowestMm;
  grid.geometry.axesMm =
    glm::dmat3((*first.axes)[0] * first.pixelMm->x, (*first.axes)[1] * first.pixelMm->y, stepMm);
  return grid;
}

/// The complete frames of a segmentation.
std::vector<DicomFrame> FramesOfFile(const std::string& path)
{
  const DicomContent content = ReadDicomContent(path);
  if (content.frames.empty())
  {
    const DicomFault fault =
      content.fault.value_or(DicomFault{ path, "a segmentation", "a file without pixels" });
    FailToRead(fault.path, fault.expected, fault.found);
  }
  return content.frames;
}

void WarnOfFractions(vtkDICOMMetaData* meta, std::vector<std::string>& warnings)
{
  if (SegmentationKindOf(meta) == SegmentationKind::Fractional)
  {
    warnings.emplace_back("The segmentation is fractional; voxels belong to a segment where it "
                          "fills, or is likely to fill, at least half of them.");
  }
}

}

Volume ReadSegmentation(const std::string& path, ReadProgress& progress)
{
  Volume volume;
  const std::vector<DicomFrame> frames = FramesOfFile(path);
  const DicomFile& file = *frames.front().file;
  CheckPlaces(path, frames);
  const DicomHeader header = ReadDicomHeader(path);
  const FrameGrid grid = GridOf(frames, volume.warnings);
  const VoxelLayout layout = { { file.columns, file.rows, grid.sliceCount }, VTK_UNSIGNED_SHORT };
  CheckedByteCount(path, layout);
  volume.segments = DescribedSegments(header.meta);
  WarnOfFractions(header.meta, volume.warnings);

  volume.image = AllocatedImage(layout);
  auto* const voxels = static_cast<std::uint16_t*>(volume.image->GetScalarPointer());
  std::fill_n(voxels, volume.image->GetNumberOfPoints(), std::uint16_t(0));
  SegmentFrames pixels(header);
  SegmentOverlap overlap;
  for (std::size_t i = 0; i < frames.size(); ++i)
  {
    const std::vector<std::uint16_t> numbers = pixels.NumbersOf(frames[i]);
    for (const std::int64_t slice : grid.slices[i])
    {
      overlap.Put(numbers, voxels + slice * file.rows * file.columns);
    }
    progress.Report(double(i + 1) / double(frames.size()));
  }
  volume.modality = file.modality;
  volume.frameOfReference = file.frameOfReference;
  overlap.Warn(*volume.segments, volume.warnings);
  PlaceImage(path, grid.geometry, volume.image);
  return volume;
}

}
