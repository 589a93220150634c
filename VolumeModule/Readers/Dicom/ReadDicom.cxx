// DICOM: vtk-dicom and GDCM read single files in a decoder; the order of slices is decided here.
#include "Readers/Decoder/DicomDecoding.h"
#include "Readers/Dicom/DicomFrame.h"
#include "Readers/Dicom/DicomSeries.h"
#include "Readers/Dicom/Grouping.h"
#include "Readers/Dicom/Metadata.h"
#include "Readers/Dicom/Segmentation.h"
#include "Readers/Dicom/Values.h"
#include "Readers/FileError.h"
#include "Readers/Formats.h"
#include "Readers/ImageGeometry.h"
#include "Readers/Packed/KeptInput.h"
#include "Readers/Parsing/NumberText.h"
#include "Readers/Times.h"
#include "Readers/VolumeFile.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace varimarch
{
namespace
{

/// Arrangement of the slices of a series: their positions, tilt and distances. The volume itself
/// always has even distances: the usual one of the slices.
class DicomStack
{
public:
  /// @param slices  at least one; must outlive this object
  explicit DicomStack(const DicomSlices& slices);

  /// Geometry of the volume with even distances.
  const ImageGeometry& Geometry() const { return this->geometry; }

  /// Positions of the first voxels of the slices [mm] if the slices were tilted, are unevenly
  /// spaced, or do not lie on a straight line; otherwise empty.
  std::vector<glm::dvec3> IrregularSlicesMm() const;

  /// True if slices are drawn elsewhere than they were scanned, and no gap is so large that
  /// interpolation would make up what lies in it.
  bool IsMisplaced() const;

  /// Warns of unknown sides and sizes, gantry tilt, missing slices and uneven distances.
  /// @param isRectified  true if the volume is resampled, which corrects tilt and distances
  void Warn(bool isRectified, std::vector<std::string>& warnings) const;

private:
  bool IsTilted() const;
  bool IsUneven() const;
  bool IsCrooked() const;
  void MeasureDistances();
  void PlaceSlices();
  void WarnOfMissingSlices(std::vector<std::string>& warnings) const;
  std::string UnevenDistances() const;
  /// A text such as "a.dcm" and "b.dcm".
  std::string NamesOfGap(std::size_t gap) const;

  const DicomSlices& slices;
  ImageGeometry geometry;
  glm::dvec3 normal = glm::dvec3(0.0, 0.0, 1.0);
  std::vector<glm::dvec3> positionsMm;
  std::vector<double> gapsMm; ///< distances of consecutive slices along the normal
  double drawnMm = 1.0;       ///< distance between the volume's slices along the normal
  double tiltDegrees = 0.0;
  double crookedMm = 0.0; ///< largest distance of a slice from its place along a straight line
};

constexpr int MostGapsNamed = 3;

/// Part of the usual distance by which distances may vary in an even stack.
constexpr double EvenPart = 0.01;

DicomStack::DicomStack(const DicomSlices& slices)
  : slices(slices)
{
  const DicomFrame& first = slices.frames.front();
  const glm::dvec2 pixelMm = first.pixelMm.value_or(glm::dvec2(first.pixelAspect, 1.0));
  const glm::dmat2x3 axes = first.axes.value_or(glm::dmat2x3(1.0));
  this->normal = glm::normalize(glm::cross(axes[0], axes[1]));
  this->geometry.axesMm[0] = axes[0] * pixelMm.x;
  this->geometry.axesMm[1] = axes[1] * pixelMm.y;
  this->geometry.originMm = first.positionMm.value_or(glm::dvec3(0.0));
  this->MeasureDistances();
  this->PlaceSlices();
}

/// The distance of an even stack is the mean one, which is more exact than a single one; that of an
/// uneven stack is the median, which a few gaps do not change.
void DicomStack::MeasureDistances()
{
  const std::vector<double>& heightsMm = this->slices.heightsMm;
  for (std::size_t i = 1; i < heightsMm.size(); ++i)
  {
    this->gapsMm.push_back(heightsMm[i] - heightsMm[i - 1]);
  }
  if (this->gapsMm.empty())
  {
    this->drawnMm = std::abs(this->slices.frames.front().distanceMm.value_or(1.0));
    return;
  }
  this->drawnMm = UsualDistanceMm(heightsMm);
  if (!this->IsUneven())
  {
    this->drawnMm = (heightsMm.back() - heightsMm.front()) / double(this->gapsMm.size());
  }
}

void DicomStack::PlaceSlices()
{
  const std::vector<DicomFrame>& frames = this->slices.frames;
  const std::vector<double>& heightsMm = this->slices.heightsMm;
  const double heightMm = heightsMm.back() - heightsMm.front();
  glm::dvec3 directionOfStack = this->normal;
  if (this->slices.hasPositions && heightMm > 0.0)
  {
    directionOfStack = (*frames.back().positionMm - *frames.front().positionMm) / heightMm;
  }
  this->geometry.axesMm[2] = directionOfStack * this->drawnMm;
  this->tiltDegrees = glm::degrees(std::acos(std::min(1.0, 1.0 / glm::length(directionOfStack))));
  for (std::size_t i = 0; i < frames.size(); ++i)
  {
    const glm::dvec3 straightMm =
      this->geometry.originMm + directionOfStack * (heightsMm[i] - heightsMm.front());
    this->positionsMm.push_back(this->slices.hasPositions ? *frames[i].positionMm : straightMm);
    this->crookedMm =
      std::max(this->crookedMm, glm::distance(this->positionsMm.back(), straightMm));
  }
}

bool DicomStack::IsTilted() const
{
  return this->tiltDegrees > 0.1;
}

bool DicomStack::IsUneven() const
{
  const auto [narrowest, widest] = std::minmax_element(this->gapsMm.begin(), this->gapsMm.end());
  return !this->gapsMm.empty() && *widest - *narrowest > EvenPart * this->drawnMm;
}

bool DicomStack::IsCrooked() const
{
  return this->crookedMm > 0.5 * glm::length(this->geometry.axesMm[0]);
}

std::vector<glm::dvec3> DicomStack::IrregularSlicesMm() const
{
  const bool isIrregular =
    !this->gapsMm.empty() && (this->IsTilted() || this->IsUneven() || this->IsCrooked());
  return isIrregular ? this->positionsMm : std::vector<glm::dvec3>();
}

bool DicomStack::IsMisplaced() const
{
  constexpr double MostOfUsual = 4.0;
  const auto isSmall = [&](double gapMm) { return gapMm <= MostOfUsual * this->drawnMm; };
  return this->slices.hasPositions && (this->IsUneven() || this->IsCrooked()) &&
    std::all_of(this->gapsMm.begin(), this->gapsMm.end(), isSmall);
}

void DicomStack::Warn(bool isRectified, std::vector<std::string>& warnings) const
{
  const DicomFrame& first = this->slices.frames.front();
  if (!first.axes || !first.isPatientSpace)
  {
    warnings.push_back(UnknownSides);
  }
  if (!first.pixelMm)
  {
    warnings.push_back("The file does not say how large a pixel is; 1 mm was taken.");
  }
  if (this->IsTilted())
  {
    const bool isDrawnTrue = !isRectified && !this->IsUneven();
    warnings.push_back("The gantry was tilted by " + ShortText(this->tiltDegrees) + " degrees" +
      (isDrawnTrue ? "; each slice is drawn at its true position, so shapes are correct." : "."));
  }
  this->WarnOfMissingSlices(warnings);
  if (this->IsUneven())
  {
    warnings.push_back(this->UnevenDistances() +
      (isRectified ? "." : ", but are drawn " + ShortText(this->drawnMm) + " mm apart."));
  }
  if (this->IsCrooked())
  {
    warnings.push_back("Slices lie up to " + ShortText(this->crookedMm) +
      " mm beside the straight line from the first to the last" +
      (isRectified ? "." : ", but are drawn on it."));
  }
}

/// Adds one sentence for each of the first gaps of one or more missing slices.
void DicomStack::WarnOfMissingSlices(std::vector<std::string>& warnings) const
{
  int count = 0;
  for (std::size_t gap = 0; gap < this->gapsMm.size(); ++gap)
  {
    const auto missing = std::lround(this->gapsMm[gap] / this->drawnMm) - 1;
    if (missing >= 1 && ++count <= MostGapsNamed)
    {
      warnings.push_back((missing == 1 ? "A slice is" : std::to_string(missing) + " slices are") +
        " missing between " + this->NamesOfGap(gap) + ".");
    }
  }
  if (count > MostGapsNamed)
  {
    warnings.push_back(
      "Slices are missing in " + std::to_string(count - MostGapsNamed) + " more places.");
  }
}

std::string DicomStack::UnevenDistances() const
{
  const auto [narrowest, widest] = std::minmax_element(this->gapsMm.begin(), this->gapsMm.end());
  return "Slices are " + ShortText(*narrowest) + " to " + ShortText(*widest) +
    " mm apart, farthest between " + this->NamesOfGap(std::size_t(widest - this->gapsMm.begin()));
}

std::string DicomStack::NamesOfGap(std::size_t gap) const
{
  return FrameName(this->slices.frames[gap]) + " and " + FrameName(this->slices.frames[gap + 1]);
}

/// The window of a frame, in its values.
std::optional<WindowLevel> WindowOf(const DicomFrame& frame)
{
  std::optional<WindowLevel> window = MetadataOf(frame.file->path, frame.number).windowLevel;
  if (window && frame.isRealWorld)
  {
    // The file recommends values that its real-world map has not been applied to.
    window->window *= std::abs(frame.slope);
    window->level = frame.slope * window->level + frame.intercept;
  }
  return window;
}

/// Windows of images spread over a series, since each costs reading a header.
std::vector<WindowLevel> SomeWindows(const std::vector<DicomFrame>& frames)
{
  constexpr std::size_t Most = 9;
  const std::size_t count = std::min(frames.size(), Most);
  std::vector<WindowLevel> windows;
  for (std::size_t i = 0; i < count; ++i)
  {
    const DicomFrame& frame = frames[count > 1 ? i * (frames.size() - 1) / (count - 1) : 0];
    if (const auto window = WindowOf(frame))
    {
      windows.push_back(*window);
    }
  }
  return windows;
}

template <class Member>
double MedianOf(std::vector<WindowLevel> windows, const Member& member)
{
  const auto middle = windows.begin() + windows.size() / 2;
  std::nth_element(windows.begin(), middle, windows.end(),
    [&](const WindowLevel& a, const WindowLevel& b) { return a.*member < b.*member; });
  return (*middle).*member;
}

/// The window and level for all images of a series: the median of those that some of its images
/// recommend. Scanners for MR and PET write another window into each image; where the images
/// disagree, and where they recommend none, it is empty, and the values decide.
std::optional<WindowLevel> WindowOfSeries(const std::vector<DicomFrame>& frames)
{
  constexpr double MostRatio = 2.0; // between two widths
  constexpr double MostShift = 0.5; // distance of two levels, in widths
  const std::vector<WindowLevel> windows = SomeWindows(frames);
  if (windows.empty())
  {
    return std::nullopt;
  }
  const WindowLevel median = { MedianOf(windows, &WindowLevel::window),
    MedianOf(windows, &WindowLevel::level) };
  const bool agree = std::all_of(windows.begin(), windows.end(),
    [&](const WindowLevel& one)
    {
      const double ratio = one.window / median.window;
      return ratio <= MostRatio && ratio >= 1.0 / MostRatio &&
        std::abs(one.level - median.level) <= MostShift * median.window;
    });
  return agree ? std::optional(median) : std::nullopt;
}

/// A volume of stored values, and its slices.
struct StoredSlices
{
  DicomSlices slices; ///< the slices that could be decoded
  vtkSmartPointer<vtkImageData> image;
  std::vector<DicomFault> faults; ///< files whose slices are missing
};

/// Indices of the slices of each file, in the order of the files' first slices.
std::vector<std::vector<int>> SlicesOfFiles(const std::vector<DicomFrame>& frames)
{
  std::vector<std::vector<int>> all;
  std::map<const DicomFile*, std::size_t> indices;
  for (std::size_t i = 0; i < frames.size(); ++i)
  {
    const std::size_t file = indices.insert({ frames[i].file.get(), all.size() }).first->second;
    all.resize(indices.size());
    all[file].push_back(int(i));
  }
  return all;
}

/// Keeps the slices that were decoded.
void LeaveOutMissing(const std::vector<bool>& isDecoded, StoredSlices& stored)
{
  vtkImageData* const all = stored.image;
  const DicomSlices slices = stored.slices;
  const int* const dimensions = all->GetDimensions();
  const auto count = std::count(isDecoded.begin(), isDecoded.end(), true);
  auto image = AllocatedImage({ { dimensions[0], dimensions[1], count }, all->GetScalarType(),
    all->GetNumberOfScalarComponents() });
  const std::size_t sliceBytes = std::size_t(dimensions[0]) * std::size_t(dimensions[1]) *
    std::size_t(all->GetNumberOfScalarComponents() * all->GetScalarSize());
  stored.slices.frames.clear();
  stored.slices.heightsMm.clear();
  for (std::size_t i = 0; i < isDecoded.size(); ++i)
  {
    if (isDecoded[i])
    {
      std::memcpy(image->GetScalarPointer(0, 0, int(stored.slices.frames.size())),
        all->GetScalarPointer(0, 0, int(i)), sliceBytes);
      stored.slices.frames.push_back(slices.frames[i]);
      stored.slices.heightsMm.push_back(slices.heightsMm[i]);
    }
  }
  stored.image = image;
}

/// Decodes slices, file by file.
/// @param path  path for error messages
/// @throws std::runtime_error if the volume does not fit in memory, or no slice can be decoded
/// @throws ReadCancelled
StoredSlices DecodedSlices(
  const std::string& path, const DicomSlices& slices, ReadProgress& progress)
{
  StoredSlices stored = { slices, nullptr, {} };
  const VoxelLayout layout = StoredLayout(slices.frames);
  CheckedByteCount(path, layout);
  stored.image = AllocatedImage(layout);
  const std::vector<std::vector<int>> files = SlicesOfFiles(slices.frames);
  std::vector<bool> isDecoded(slices.frames.size(), false);
  std::vector<const DicomFile*> toDecode;
  for (const std::vector<int>& slicesOfFile : files)
  {
    toDecode.push_back(slices.frames[std::size_t(slicesOfFile.front())].file.get());
    CheckFrames(path, *toDecode.back());
  }
  ForEachDecoded(
    toDecode,
    [&](std::size_t i, const DecodedPixels& pixels)
    {
      if (pixels.fault)
      {
        stored.faults.push_back(*pixels.fault);
      }
      for (const int slice : pixels.fault ? std::vector<int>() : files[i])
      {
        PutSlice(slices.frames[std::size_t(slice)], pixels.image, stored.image, slice);
        isDecoded[std::size_t(slice)] = true;
      }
    },
    progress);
  if (stored.faults.size() == files.size())
  {
    const DicomFault& fault = stored.faults.front();
    FailToRead(fault.path, fault.expected, fault.found);
  }
  if (!stored.faults.empty())
  {
    LeaveOutMissing(isDecoded, stored);
  }
  return stored;
}

/// Takes further metadata, none of which identifies the patient, from a slice.
void TakeMetadata(const DicomFrame& slice, Volume& volume)
{
  const DicomMetadata metadata = MetadataOf(slice.file->path, slice.number);
  volume.modality = metadata.modality;
  volume.frameOfReference = slice.file->frameOfReference;
  volume.bodyPart = metadata.bodyPart;
  volume.hasContrastAgent = metadata.hasContrastAgent;
  volume.weighting = metadata.weighting;
  volume.uptakeValueFactor = metadata.uptakeValueFactor;
  if (!metadata.uptakeDoubt.empty())
  {
    volume.warnings.push_back(
      "Standardized uptake values are unknown: " + metadata.uptakeDoubt + ".");
  }
  volume.isInverted = metadata.isInverted;
  if (slice.file->colours == "PALETTE COLOR" && slice.file->palette.entries.empty())
  {
    volume.warnings.push_back(
      "The photometric interpretation is PALETTE COLOR, which is not converted to brightness.");
  }
}

/// Names files that cannot be read.
void WarnOfFaults(const std::vector<DicomFault>& faults, std::vector<std::string>& warnings)
{
  constexpr std::size_t MostNamed = 3;
  for (std::size_t i = 0; i < std::min(faults.size(), MostNamed); ++i)
  {
    const DicomFault& fault = faults[i];
    warnings.push_back("Images of \"" + fault.path + "\" were left out: expected " +
      fault.expected + ", found " + fault.found + ".");
  }
  if (faults.size() > MostNamed)
  {
    warnings.push_back("Images of " + std::to_string(faults.size() - MostNamed) +
      " more files were left out, which cannot be read either.");
  }
}

/// Warns of images that lossy compression has changed.
void WarnOfLoss(const std::vector<DicomFrame>& frames, std::vector<std::string>& warnings)
{
  std::vector<DicomFrame> lossy;
  std::copy_if(frames.begin(), frames.end(), std::back_inserter(lossy),
    [](const DicomFrame& frame) { return frame.isLossy; });
  if (!lossy.empty())
  {
    warnings.push_back(std::to_string(lossy.size()) + " of " + std::to_string(frames.size()) +
      " images were compressed with loss, which may hide details: " + FrameList(lossy) + ".");
  }
}

/// Warns of a map of values that the files have beside the one that was applied.
void WarnOfOtherMaps(const std::vector<DicomFrame>& frames, std::vector<std::string>& warnings)
{
  constexpr std::size_t LongestUnit = 40;
  const auto frame = std::find_if(frames.begin(), frames.end(),
    [](const DicomFrame& candidate) { return !candidate.otherMap.empty(); });
  if (frame != frames.end())
  {
    warnings.push_back("The files also map their values to " +
      Quoted(frame->otherMap, LongestUnit) + "; this map was not applied.");
  }
}

/// Faults of files of a series, and of files of which nothing is known.
std::vector<DicomFault> FaultsOf(const DicomScan& scan, const DicomSeries& series)
{
  std::vector<DicomFault> faults;
  std::copy_if(scan.faults.begin(), scan.faults.end(), std::back_inserter(faults),
    [&](const DicomFault& fault)
    { return fault.seriesUid.empty() || fault.seriesUid == series.uid; });
  return faults;
}

/// The kind of volume to read.
/// @throws std::runtime_error, with a list of all kinds, if there is none of the wanted number
const DicomVolumes& KindWanted(const std::string& path, const std::vector<DicomVolumes>& kinds,
  const ReadOptions& options, std::vector<std::string>& warnings)
{
  if (options.kind < 0 || options.kind > int(kinds.size()))
  {
    FailToRead(path, "the kind of volume " + std::to_string(options.kind),
      std::to_string(kinds.size()) + ": " + KindList(kinds));
  }
  if (options.kind == 0 && kinds.size() > 1)
  {
    warnings.push_back("The series holds " + std::to_string(kinds.size()) +
      " kinds of volume, of which the first was read: " + KindList(kinds) + ".");
  }
  const DicomVolumes& wanted = kinds[std::size_t(std::max(options.kind, 1)) - 1];
  warnings.insert(warnings.end(), wanted.warnings.begin(), wanted.warnings.end());
  return wanted;
}

/// Reads the images of a series as slices of a volume.
Volume ReadSlices(const std::string& path, const DicomSeries& series, const ReadOptions& options,
  ReadProgress& progress)
{
  Volume volume;
  const std::vector<DicomVolumes> kinds = KindsOf(series.frames);
  const DicomVolumes& volumes = KindWanted(path, kinds, options, volume.warnings);
  std::transform(kinds.begin(), kinds.end(), std::back_inserter(volume.kinds),
    [](const DicomVolumes& kind) { return kind.name; });
  TakeTimes(path, volumes.times, options, volume);
  const StoredSlices stored =
    DecodedSlices(path, SlicesOf(volumes, options.time, volume.warnings), progress);
  WarnOfFaults(stored.faults, volume.warnings);
  const std::vector<DicomFrame>& frames = stored.slices.frames;
  volume.image = Rescaled(path, stored.image, RescalesOf(frames));
  volume.lowestInside = SetPaddingToLowest(frames, volume.image, volume.warnings);
  const DicomStack stack(stored.slices);
  PlaceImage(path, stack.Geometry(), volume.image);
  volume.irregularSlicesMm = stack.IrregularSlicesMm();
  volume.isMisplaced = stack.IsMisplaced();
  stack.Warn(options.Rectifies(volume), volume.warnings);
  WarnOfLoss(frames, volume.warnings);
  WarnOfOtherMaps(frames, volume.warnings);
  TakeMetadata(frames.front(), volume);
  volume.windowLevel = WindowOfSeries(frames);
  return volume;
}

/// Reads the segmentation in the first file of a series.
Volume ReadFirstSegmentation(const DicomSeries& series, ReadProgress& progress)
{
  const DicomFile& first = *series.frames.front().file;
  Volume volume = ReadSegmentation(first.path, progress);
  std::vector<DicomFrame> others;
  std::copy_if(series.frames.begin(), series.frames.end(), std::back_inserter(others),
    [&](const DicomFrame& frame) { return frame.file.get() != &first; });
  if (!others.empty())
  {
    volume.warnings.push_back("The series holds several segmentations, of which only the first "
                              "was read; the others: " +
      FrameList(others) + ".");
  }
  return volume;
}

}

Volume ReadDicom(const std::string& path, const ReadOptions& options, ReadProgress& progress)
{
  ReadProgress scanning = progress.Part(0.0, 0.3);
  ReadProgress decoding = progress.Part(0.3, 1.0);
  KeptInput once;
  KeptInput& kept = options.kept ? *options.kept : once;
  if (!kept.scan)
  {
    kept.scan = std::make_unique<const DicomScan>(FindDicomSeries(path, scanning));
  }
  const DicomScan& scan = *kept.scan;
  const DicomSeries& series = SeriesNamed(path, scan.series, options.series);
  std::vector<std::string> warnings = scan.warnings;
  if (options.series.empty() && scan.series.size() > 1)
  {
    warnings.push_back("This is the first of several series: " + SeriesList(scan.series) + ".");
  }
  WarnOfFaults(FaultsOf(scan, series), warnings);
  Volume volume = IsSegmentation(series) ? ReadFirstSegmentation(series, decoding)
                                         : ReadSlices(path, series, options, decoding);
  volume.holdsColors = volume.image->GetNumberOfScalarComponents() > 1;
  volume.warnings.insert(volume.warnings.begin(), warnings.begin(), warnings.end());
  return volume;
}

}
