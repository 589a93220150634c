// Files that the user has declared to be times: those of a folder, or those whose names differ from
// that of a file in its last number only.
#include "Readers/FileError.h"
#include "Readers/Formats.h"
#include "Readers/Packed/KeptInput.h"
#include "Readers/Times.h"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <filesystem>

namespace varimarch
{
namespace
{

/// A file name around its last number before the extension.
struct NumberedName
{
  std::string begin;
  std::string end;
};

bool IsDigit(char character)
{
  return std::isdigit(static_cast<unsigned char>(character)) != 0;
}

/// The name without the last run of digits before its first dot.
NumberedName NumberedNameOf(const std::string& name)
{
  const std::size_t dot = name.find('.');
  const std::string stem = name.substr(0, dot);
  const auto last = std::find_if(stem.rbegin(), stem.rend(), IsDigit).base();
  const auto first =
    std::find_if_not(std::make_reverse_iterator(last), stem.rend(), IsDigit).base();
  const auto beginCount = std::size_t(first - stem.begin());
  const auto endAt = std::size_t(last - stem.begin());
  return { name.substr(0, beginCount), name.substr(endAt) };
}

bool HasName(const std::string& name, const NumberedName& pattern)
{
  const std::size_t ends = pattern.begin.size() + pattern.end.size();
  if (name.size() <= ends || name.compare(0, pattern.begin.size(), pattern.begin) != 0 ||
    name.compare(name.size() - pattern.end.size(), std::string::npos, pattern.end) != 0)
  {
    return false;
  }
  const std::string number = name.substr(pattern.begin.size(), name.size() - ends);
  return std::all_of(number.begin(), number.end(), IsDigit);
}

bool IsVolumeFile(const std::string& path)
{
  const VolumeFormat* const format = FormatOfMember(path);
  return format && format->read != ReadPacked;
}

/// The files in the order of the numbers in their names; none if their folder cannot be read.
std::vector<std::string> FilesOfTimes(const std::string& path)
{
  const std::filesystem::path given(path);
  const bool isFolder = std::filesystem::is_directory(given);
  const std::filesystem::path parent = given.parent_path().empty() ? "." : given.parent_path();
  const NumberedName pattern = NumberedNameOf(given.filename().string());
  std::vector<std::string> files;
  std::error_code unknown;
  std::error_code ignored;
  for (std::filesystem::directory_iterator entry(isFolder ? given : parent, unknown);
       !unknown && entry != std::filesystem::directory_iterator(); entry.increment(unknown))
  {
    const std::string name = entry->path().filename().string();
    if (entry->is_regular_file(ignored) && name.front() != '.' &&
      (isFolder ? IsVolumeFile(entry->path().string()) : HasName(name, pattern)))
    {
      files.push_back(entry->path().string());
    }
  }
  std::sort(files.begin(), files.end(),
    [](const std::string& a, const std::string& b)
    { return strverscmp(a.c_str(), b.c_str()) < 0; });
  return files;
}

std::string SizeText(const std::array<int, 3>& size)
{
  return std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " +
    std::to_string(size[2]) + " voxels";
}

/// Fails unless an image is as large as the first of the times that was read.
void CheckSize(const std::string& path, vtkImageData* image, KeptInput& kept)
{
  std::array<int, 3> size;
  image->GetDimensions(size.data());
  kept.sizeOfFiles = kept.sizeOfFiles.value_or(size);
  if (size != *kept.sizeOfFiles)
  {
    FailToRead(path, SizeText(*kept.sizeOfFiles) + " as at the other times", SizeText(size));
  }
}

}

Volume ReadFilesAsTimes(const std::string& path, const ReadOptions& options, ReadProgress& progress)
{
  const std::vector<std::string> files = FilesOfTimes(path);
  if (files.size() < 2)
  {
    FailToRead(path,
      "a folder with several volumes, or one of several files whose names differ in their last "
      "number, such as scan_001.nii.gz",
      files.empty() ? "no volume" : "a single one");
  }
  Volume times;
  TakeTimes(path, NumberedTimes(std::int64_t(files.size())), options, times);
  ReadOptions ofFile = options;
  ofFile.time = 0;
  ofFile.filesAreTimes = false;
  ofFile.kept = nullptr;
  const std::string& file = files[std::size_t(options.time)];
  Volume volume = ReadUnrectified(file, ofFile, progress);
  KeptInput once;
  CheckSize(file, volume.image, options.kept ? *options.kept : once);
  volume.times = times.times;
  return volume;
}

}
