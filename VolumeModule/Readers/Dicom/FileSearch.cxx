#include "Readers/Dicom/FileSearch.h"

#include "Readers/Dicom/Metadata.h"
#include "Readers/Parsing/HeaderText.h"

#include <algorithm>
#include <filesystem>
#include <set>

namespace varimarch
{
namespace
{

namespace fs = std::filesystem;

constexpr int DeepestFolder = 32;

bool IsIndex(const fs::path& path)
{
  return LowerCase(path.filename().string()) == "dicomdir";
}

/// The index in a folder, or an empty path.
fs::path IndexIn(const fs::path& folder)
{
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
  {
    if (IsIndex(entry.path()) && entry.is_regular_file(ignored))
    {
      return entry.path();
    }
  }
  return {};
}

/// Files of a folder and its subfolders, in the order of their paths. A folder that links lead to
/// twice is searched once.
std::vector<std::string> FilesBelow(
  const fs::path& folder, std::vector<std::string>& warnings, ReadProgress& progress)
{
  std::vector<std::string> files;
  std::set<fs::path> searched = { fs::canonical(folder) };
  std::error_code ignored;
  auto entry = fs::recursive_directory_iterator(folder,
    fs::directory_options::follow_directory_symlink | fs::directory_options::skip_permission_denied,
    ignored);
  for (; entry != fs::recursive_directory_iterator(); entry.increment(ignored))
  {
    progress.Report(0.0);
    if (entry->is_regular_file(ignored))
    {
      files.push_back(entry->path().string());
    }
    else if (entry->is_directory(ignored))
    {
      const bool isNew = searched.insert(fs::canonical(entry->path(), ignored)).second;
      const bool isTooDeep = entry.depth() >= DeepestFolder;
      if (isTooDeep)
      {
        warnings.push_back("The folder \"" + entry->path().string() +
          "\" was not searched; it is more than " + std::to_string(DeepestFolder) +
          " levels deep.");
      }
      if (!isNew || isTooDeep)
      {
        entry.disable_recursion_pending();
      }
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

}

std::vector<std::string> FindDicomFiles(
  const std::string& path, std::vector<std::string>& warnings, ReadProgress& progress)
{
  if (IsIndex(path))
  {
    return FilesOfIndex(path, progress);
  }
  if (!fs::is_directory(path))
  {
    return { path };
  }
  const fs::path index = IndexIn(path);
  const std::vector<std::string> listed =
    index.empty() ? std::vector<std::string>() : FilesOfIndex(index.string(), progress);
  return listed.empty() ? FilesBelow(path, warnings, progress) : listed;
}

}
