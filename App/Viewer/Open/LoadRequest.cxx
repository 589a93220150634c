#include "Viewer/Open/LoadRequest.h"

#include "Readers/Decoder/DecoderSession.h"
#include "Readers/Dicom/FileSearch.h"
#include "Readers/Dicom/Metadata.h"
#include "Scene/Json/SceneFile.h"
#include "Viewer/Model/RecentScans.h"
#include "Viewer/Model/StudyTimes.h"

#include <vtkVolumeFileReader.h>

#include <QFileInfo>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <set>
#include <stdexcept>
#include <utility>

namespace varimarch
{

namespace
{

const std::string DicomFormat = "DICOM";

// Formats of files that hold the voxels for a header beside them.
const std::set<std::string> VoxelFormats = { "Analyze", "AFNI voxels", "PAR/REC voxels", "raw" };

const std::set<std::string> StackFormats = { "TIFF", "image stack" };

// The format of a file; empty for none. Sessions are a format of this program.
std::string FormatOf(const std::string& path)
{
  const char* const format = vtkVolumeFileReader::GetFormatOfFile(path.c_str());
  return format ? format : IsSceneFile(path) ? "session" : "";
}

bool IsDicomOrFolder(const std::string& path)
{
  return std::filesystem::is_directory(path) || FormatOf(path) == DicomFormat ||
    std::filesystem::path(path).filename() == "DICOMDIR";
}

bool IsStackSlice(const std::string& path)
{
  return StackFormats.count(FormatOf(path)) > 0;
}

// The innermost folder that holds all files.
std::filesystem::path FolderOf(const std::vector<std::string>& paths)
{
  std::filesystem::path shared = std::filesystem::path(paths.front()).parent_path();
  for (const std::string& path : paths)
  {
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    const auto parts =
      std::mismatch(shared.begin(), shared.end(), folder.begin(), folder.end()).first;
    std::filesystem::path common;
    std::for_each(
      shared.begin(), parts, [&](const std::filesystem::path& part) { common /= part; });
    shared = common;
  }
  return shared;
}

// True if files lie in a folder, or a little below. All of a folder is read to find a series, so
// one that only files of different places share is not.
bool AreNear(const std::vector<std::string>& paths, const std::filesystem::path& folder)
{
  constexpr int MostLevels = 3;
  const auto levels = [](const std::filesystem::path& path)
  { return std::distance(path.begin(), path.end()); };
  return std::all_of(paths.begin(), paths.end(),
    [&](const std::string& path) { return levels(path) <= levels(folder) + MostLevels; });
}

// The paths that are scans or parts of scans.
std::vector<std::string> Volumes(const std::vector<std::string>& paths)
{
  std::vector<std::string> volumes;
  std::copy_if(paths.begin(), paths.end(), std::back_inserter(volumes),
    [](const std::string& path)
    {
      const std::string format = FormatOf(path);
      return IsDicomOrFolder(path) || (!format.empty() && VoxelFormats.count(format) == 0);
    });
  return volumes;
}

// True if a folder has no other slices of a stack than these.
bool AreWholeStack(const std::vector<std::string>& slices, const std::filesystem::path& folder)
{
  const auto inFolder = std::count_if(std::filesystem::directory_iterator(folder),
    std::filesystem::directory_iterator(),
    [](const auto& entry) { return IsStackSlice(entry.path().string()); });
  return std::size_t(inFolder) == slices.size();
}

// Several files and folders as one scan, or as series of DICOM to choose from.
struct FilesTogether
{
  std::string path; ///< the file or folder to open
  /// The DICOM files and folders whose series are meant; empty for a path that is meant as a whole.
  std::vector<std::string> ofSeries;
};

FilesTogether FoundTogether(const std::vector<std::string>& paths)
{
  const std::vector<std::string> volumes = Volumes(paths);
  if (volumes.size() == 1)
  {
    return { volumes.front(), {} };
  }
  if (!volumes.empty() && std::all_of(volumes.begin(), volumes.end(), IsDicomOrFolder) &&
    AreNear(volumes, FolderOf(volumes)))
  {
    return { FolderOf(volumes).string(), volumes };
  }
  if (!volumes.empty() && std::all_of(volumes.begin(), volumes.end(), IsStackSlice) &&
    AreWholeStack(volumes, FolderOf(volumes)))
  {
    return { FolderOf(volumes).string(), {} };
  }
  throw std::runtime_error("Cannot open " + std::to_string(paths.size()) +
    " files at once: expected DICOM images that lie together, all slices of a folder of images, or "
    "a header with its voxels, found " +
    (volumes.empty() ? "no file of a known format" : std::to_string(volumes.size()) + " volumes") +
    "; open one of them, and add others by File, Add a scan");
}

// The series to which the images of DICOM files and folders belong.
std::vector<SeriesSummary> SeriesOfFiles(const std::vector<SeriesSummary>& all,
  const std::vector<std::string>& paths, const LoadObserver& observe)
{
  const DecoderSession session;
  ReadProgress progress([&](double part) { return !observe || observe(part); });
  std::vector<std::string> files;
  std::vector<std::string> ignored; // reading the folder tells them too
  for (const std::string& path : paths)
  {
    const std::vector<std::string> found = FindDicomFiles(path, ignored, progress);
    files.insert(files.end(), found.begin(), found.end());
  }
  std::set<std::string> uids;
  ForEachRecord(
    files, [&](std::size_t, const DicomRecord& record) { uids.insert(record.seriesUid); },
    progress);
  std::vector<SeriesSummary> named;
  std::copy_if(all.begin(), all.end(), std::back_inserter(named),
    [&](const SeriesSummary& series) { return uids.count(series.uid) > 0; });
  return named;
}

bool IsSegmentation(const SeriesSummary& series)
{
  return series.modality == "SEG";
}

LoadedVolume LoadWithinMemory(
  const VolumeSource& source, const LoadObserver& observe, bool mayBePreview = false)
{
  const auto* const file = std::get_if<FileSource>(&source);
  return LoadVolume(file ? WithinMemory(*file) : source, observe, mayBePreview);
}

Study StudyWithoutLabels(LoadedVolume volume)
{
  ImageStatistics statistics(volume.image);
  return { std::move(volume), std::move(statistics) };
}

// The volume as a study, with labels over it. Labels that cannot be read do not lose the volume.
std::shared_ptr<const Study> StudyOf(LoadedVolume volume, const std::string& path,
  const std::optional<SceneLabels>& labels, const LoadObserver& observe)
{
  Study study = StudyWithoutLabels(std::move(volume));
  try
  {
    if (labels)
    {
      return WithLabels(study, LoadLabels(*labels, study.volume, observe));
    }
    if (!study.volume.segments.empty())
    {
      LabelMap own = LabelMapOf(study.volume, path, study.volume);
      own.warnings.clear(); // they are those of the volume
      return WithLabels(study, std::move(own));
    }
  }
  catch (const std::runtime_error& reason)
  {
    study.volume.warnings.push_back(reason.what());
  }
  return std::make_shared<const Study>(std::move(study));
}

// The volume over another one. It is drawn by its look even if its values are labels.
std::shared_ptr<const Study> OverlayStudy(
  const OverlaidVolume& overlay, const LoadObserver& observe)
{
  LoadedVolume volume = LoadWithinMemory(overlay.source, observe);
  return overlay.labels ? StudyOf(std::move(volume), {}, overlay.labels, observe)
                        : std::make_shared<const Study>(StudyWithoutLabels(std::move(volume)));
}

// The volume with others over it. One that cannot be read is null.
std::shared_ptr<const Study> WithOverlays(const std::shared_ptr<const Study>& first,
  const std::vector<OverlaidVolume>& overlays, const LoadObserver& observe)
{
  Study study = *first;
  for (const OverlaidVolume& overlay : overlays)
  {
    study.overlays.emplace_back();
    try
    {
      study.overlays.back() = OverlayStudy(overlay, observe);
    }
    catch (const std::runtime_error& reason)
    {
      study.volume.warnings.push_back(reason.what());
    }
  }
  return std::make_shared<const Study>(std::move(study));
}

// The only series that fulfils a condition.
template <class Condition>
const SeriesSummary* OnlySeries(const std::vector<SeriesSummary>& series, const Condition& isWanted)
{
  const auto first = std::find_if(series.begin(), series.end(), isWanted);
  return std::count_if(series.begin(), series.end(), isWanted) == 1 ? &*first : nullptr;
}

// The series to open without a question; null if the user has to choose.
const SeriesSummary* SeriesToOpen(const std::vector<SeriesSummary>& series, const QString& digest)
{
  if (!digest.isEmpty())
  {
    return OnlySeries(
      series, [&](const SeriesSummary& one) { return DigestOfSeries(one.uid) == digest; });
  }
  return series.size() == 1 ? &series.front() : OnlySeries(series, std::not_fn(IsSegmentation));
}

// Reads a volume. Its coarse copy, if it has one, is shown before, as a volume of one time: each
// other time would be read whole.
LoadedVolume ReadShowing(
  const VolumeSource& source, const LoadObserver& observe, const ShowPreview& show)
{
  LoadedVolume volume = LoadWithinMemory(source, observe, bool(show));
  if (volume.isPreview)
  {
    volume.times = {};
    show(source, std::make_shared<const Study>(StudyWithoutLabels(std::move(volume))));
    volume = LoadWithinMemory(source, observe);
  }
  return volume;
}

// A volume to read, with what lies over it.
struct WantedVolume
{
  VolumeSource source;
  QString digest = {};
  std::optional<SceneLabels> labels = {};
  std::vector<OverlaidVolume> overlays = {};
  /// The DICOM files and folders whose series are meant; empty for all that the source holds.
  std::vector<std::string> ofSeries = {};
};

// Finds the series of a folder, and names the one to read in the source. False if the user has to
// choose.
bool ChooseSeries(const WantedVolume& wanted, LoadResult& found, const LoadObserver& observe)
{
  auto* const file = std::get_if<FileSource>(&found.source);
  if (!file || !MayHoldSeveralSeries(*file))
  {
    return true;
  }
  found.series = ListSeries(file->path, observe);
  if (!wanted.ofSeries.empty())
  {
    found.series = SeriesOfFiles(found.series, wanted.ofSeries, observe);
  }
  const SeriesSummary* const chosen = SeriesToOpen(found.series, wanted.digest);
  if (!chosen && (!found.series.empty() || !wanted.digest.isEmpty()))
  {
    return false;
  }
  // The only series of a folder needs no name.
  const bool isOneOfMore =
    found.series.size() > 1 || !wanted.digest.isEmpty() || !wanted.ofSeries.empty();
  if (chosen && isOneOfMore)
  {
    file->series = chosen->uid;
  }
  return true;
}

LoadResult ReadWanted(
  const WantedVolume& wanted, const LoadObserver& observe, const ShowPreview& show = {})
{
  LoadResult found;
  found.source = wanted.source;
  if (!ChooseSeries(wanted, found, observe))
  {
    return found;
  }
  const auto* const file = std::get_if<FileSource>(&found.source);
  found.study = StudyOf(ReadShowing(found.source, observe, show), file ? file->path : std::string(),
    wanted.labels, observe);
  if (!wanted.overlays.empty())
  {
    found.study = WithOverlays(found.study, wanted.overlays, observe);
  }
  return found;
}

LoadResult ReadDropped(const DroppedFile& dropped, const LoadObserver& observe)
{
  const std::string& path = dropped.path;
  LoadResult found;
  found.source = FileSource{ path, std::nullopt };
  found.labels.path = path;
  LoadedVolume volume = LoadWithinMemory(found.source, observe);
  const bool areLabels = !volume.segments.empty();
  try
  {
    found.labelled = WithLabelsOnOne(dropped.scans, volume, path);
    if (!areLabels && found.labelled->labels->segments.size() >= std::size_t(MostSegments))
    {
      found.labelled.reset(); // so many values are rather those of a scan
    }
  }
  catch (const std::runtime_error&)
  {
    // They belong to none of the scans.
    if (areLabels)
    {
      throw;
    }
  }
  if (!areLabels)
  {
    found.study = StudyOf(std::move(volume), path, std::nullopt, observe);
  }
  return found;
}

// Reads each kind of request.
struct RequestReader
{
  const LoadObserver& observe;
  const ShowPreview& show;

  LoadResult operator()(const NewScan& scan) const
  {
    return ReadWanted({ scan.source, scan.digest }, this->observe, this->show);
  }

  LoadResult operator()(const ScanOfFiles& scan) const
  {
    const FilesTogether files = FoundTogether(scan.paths);
    WantedVolume wanted = { FileSource{ files.path, std::nullopt } };
    wanted.ofSeries = files.ofSeries;
    return ReadWanted(wanted, this->observe, this->show);
  }

  LoadResult operator()(const SavedSession& session) const
  {
    const Scene& scene = session.scene;
    return ReadWanted({ scene.volume, {}, scene.labels, scene.overlays }, this->observe);
  }

  LoadResult operator()(const AddedScan& scan) const
  {
    return ReadWanted({ scan.source }, this->observe);
  }

  LoadResult operator()(const OtherForm& form) const
  {
    return ReadWanted({ form.source, {}, form.labels }, this->observe);
  }

  LoadResult operator()(const LabelsOverScan& over) const
  {
    LoadResult found;
    found.labels = over.labels;
    found.labelled =
      WithLabels(*over.scan, LoadLabels(over.labels, over.scan->volume, this->observe));
    return found;
  }

  LoadResult operator()(const DroppedFile& dropped) const
  {
    return ReadDropped(dropped, this->observe);
  }
};

// The file that each kind of request names first.
struct PathFinder
{
  std::string operator()(const VolumeSource& source) const
  {
    const auto* const file = std::get_if<FileSource>(&source);
    return file ? file->path : std::string();
  }

  std::string operator()(const NewScan& scan) const { return (*this)(scan.source); }
  std::string operator()(const SavedSession& session) const
  {
    return (*this)(session.scene.volume);
  }
  std::string operator()(const AddedScan& scan) const { return (*this)(scan.source); }
  std::string operator()(const OtherForm& form) const { return (*this)(form.source); }
  std::string operator()(const LabelsOverScan& over) const { return over.labels.path; }
  std::string operator()(const DroppedFile& dropped) const { return dropped.path; }

  std::string operator()(const ScanOfFiles& scan) const
  {
    return QFileInfo(QString::fromStdString(scan.paths.front())).path().toStdString();
  }
};

}

QString PathOf(const LoadRequest& request)
{
  return QString::fromStdString(std::visit(PathFinder(), request));
}

std::vector<SeriesSummary> SegmentationsAmong(const std::vector<SeriesSummary>& series)
{
  std::vector<SeriesSummary> found;
  std::copy_if(series.begin(), series.end(), std::back_inserter(found), IsSegmentation);
  return found;
}

LoadRequest WithSeries(const LoadRequest& request, const LoadResult& found, const std::string& uid)
{
  FileSource chosen = std::get<FileSource>(found.source);
  chosen.series = uid;
  const std::vector<SeriesSummary> segmentations = SegmentationsAmong(found.series);
  if (const auto* const session = std::get_if<SavedSession>(&request))
  {
    SavedSession other = { session->scene, session->isAutosaved, segmentations };
    other.scene.volume = chosen;
    return other;
  }
  if (std::holds_alternative<AddedScan>(request))
  {
    return AddedScan{ chosen };
  }
  if (const auto* const form = std::get_if<OtherForm>(&request))
  {
    return OtherForm{ chosen, form->labels };
  }
  return NewScan{ chosen, {}, segmentations };
}

LoadResult ReadRequest(
  const LoadRequest& request, const LoadObserver& observe, const ShowPreview& show)
{
  return std::visit(RequestReader{ observe, show }, request);
}

}
