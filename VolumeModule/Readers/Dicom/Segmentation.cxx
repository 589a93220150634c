#include "Readers/Dicom/Segmentation.h"

#include "Readers/Dicom/FileFrames.h"
#include "Readers/Dicom/FileHeader.h"
#include "Readers/Dicom/SegmentFrames.h"
#include "Readers/FileError.h"
#include "Readers/ImageGeometry.h"
#include "Readers/SegmentOverlap.h"
#include "Readers/VoxelLayout.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace varimarch
{
namespace
{

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
