// DICOM: vtk-dicom and GDCM read single files in a decoder; the order of slices is decided here.
#include "Readers/Dicom/DicomSeries.h"
#include "Readers/Dicom/DicomStack.h"
#include "Readers/Dicom/Grouping.h"
#include "Readers/Dicom/Metadata.h"
#include "Readers/Dicom/Segmentation.h"
#include "Readers/Dicom/SeriesWindow.h"
#include "Readers/Dicom/StoredSlices.h"
#include "Readers/Dicom/Values.h"
#include "Readers/FileError.h"
#include "Readers/Formats.h"
#include "Readers/KeptInput.h"
#include "Readers/Times.h"

#include <algorithm>

namespace varimarch
{
namespace
{

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
