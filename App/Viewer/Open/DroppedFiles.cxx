#include "Viewer/Open/DroppedFiles.h"

#include "Readers/Decoder/DecoderSession.h"
#include "Readers/Dicom/FileSearch.h"
#include "Readers/Dicom/Record.h"
#include "Scene/SceneFile.h"

#include <vtkVolumeFileReader.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <set>
#include <stdexcept>

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

}

DroppedFiles TogetherDropped(const std::vector<std::string>& paths)
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

}
