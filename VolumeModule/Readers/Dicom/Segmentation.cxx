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
#include <limits>

namespace varimarch
{
namespace
{

/// The grid that the frames of a segmentation lie on, and the slice of each frame.
struct FrameGrid
{
  ImageGeometry geometry;
  std::vector<std::int64_t> slices;
  std::int64_t sliceCount = 1;
};

bool IsParallel(const DicomFrame& a, const DicomFrame& b)
{
  constexpr double LargestDifference = 0.001;
  return a.size == b.size && glm::distance((*a.axes)[0], (*b.axes)[0]) < LargestDifference &&
    glm::distance((*a.axes)[1], (*b.axes)[1]) < LargestDifference &&
    glm::distance(*a.pixelMm, *b.pixelMm) < LargestDifference * glm::length(*a.pixelMm);
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

/// Distance of the slices: the stated one if the frames fit to it, else the smallest that occurs,
/// for most segments have no frame on some slices.
double SliceDistanceMm(std::vector<double> heightsMm, const DicomFrame& first)
{
  constexpr double SamePlace = 1e-3;
  const double statedMm = std::abs(first.distanceMm.value_or(0.0));
  std::sort(heightsMm.begin(), heightsMm.end());
  double smallestMm = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < heightsMm.size(); ++i)
  {
    const double gapMm = heightsMm[i] - heightsMm[i - 1];
    smallestMm = gapMm > SamePlace ? std::min(smallestMm, gapMm) : smallestMm;
  }
  if (std::isinf(smallestMm))
  {
    return statedMm > 0.0 ? statedMm : 1.0;
  }
  const double steps = smallestMm / statedMm;
  constexpr double LargestDifference = 0.05;
  const bool isStated = statedMm > 0.0 && !first.isDistanceThickness && std::lround(steps) > 0 &&
    std::abs(steps - double(std::lround(steps))) < LargestDifference;
  return isStated ? smallestMm / double(std::lround(steps)) : smallestMm;
}

FrameGrid GridOf(const std::vector<DicomFrame>& frames, std::vector<std::string>& warnings)
{
  constexpr double LargestOffset = 0.1; // part of the distance of two slices
  const DicomFrame& first = frames.front();
  const glm::dvec3 normal = glm::normalize(glm::cross((*first.axes)[0], (*first.axes)[1]));
  std::vector<double> heightsMm;
  for (const DicomFrame& frame : frames)
  {
    heightsMm.push_back(glm::dot(*frame.positionMm, normal));
  }
  const double distanceMm = SliceDistanceMm(heightsMm, first);
  const auto [lowest, highest] = std::minmax_element(heightsMm.begin(), heightsMm.end());
  FrameGrid grid;
  double farthest = 0.0;
  for (const double heightMm : heightsMm)
  {
    const double slice = (heightMm - *lowest) / distanceMm;
    grid.slices.push_back(std::int64_t(std::llround(slice)));
    grid.sliceCount = std::max(grid.sliceCount, grid.slices.back() + 1);
    farthest = std::max(farthest, std::abs(slice - std::round(slice)));
  }
  if (farthest > LargestOffset)
  {
    warnings.emplace_back("The frames of the segmentation lie at uneven distances; each was moved "
                          "to the nearest of the even slices.");
  }
  // Frames of a tilted gantry are displaced along their rows or columns too.
  const glm::dvec3 lowestMm = *frames[std::size_t(lowest - heightsMm.begin())].positionMm;
  const glm::dvec3 highestMm = *frames[std::size_t(highest - heightsMm.begin())].positionMm;
  const glm::dvec3 stepMm = grid.sliceCount > 1
    ? (highestMm - lowestMm) / double(grid.sliceCount - 1)
    : normal * distanceMm;
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
    overlap.Put(numbers, voxels + std::int64_t(grid.slices[i]) * file.rows * file.columns);
    progress.Report(double(i + 1) / double(frames.size()));
  }
  volume.modality = file.modality;
  volume.frameOfReference = file.frameOfReference;
  overlap.Warn(*volume.segments, volume.warnings);
  PlaceImage(path, grid.geometry, volume.image);
  return volume;
}

}
