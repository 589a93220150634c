#include "Scene/PartFiles.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace varimarch
{

namespace
{

namespace fs = std::filesystem;

const std::string partPrefix = "varimarch-";
const std::string partMark = ".part";

// Deletes a file of this user unless a process holds its lock.
void DeleteUnlessLocked(const fs::path& path)
{
  const int file = open(path.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  struct stat status = {};
  if (file >= 0 && fstat(file, &status) == 0 && S_ISREG(status.st_mode) &&
    status.st_uid == geteuid() && flock(file, LOCK_EX | LOCK_NB) == 0)
  {
    unlink(path.c_str());
  }
  if (file >= 0)
  {
    close(file);
  }
}

// The same for a folder, whose lock is that of the folder itself.
void DeleteFolderUnlessLocked(const fs::path& path)
{
  const int folder = open(path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  struct stat status = {};
  if (folder >= 0 && fstat(folder, &status) == 0 && status.st_uid == geteuid() &&
    flock(folder, LOCK_EX | LOCK_NB) == 0)
  {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
  if (folder >= 0)
  {
    close(folder);
  }
}

}

void FailToWrite(const std::string& path)
{
  throw std::runtime_error(path + ": cannot be written: " + std::strerror(errno));
}

fs::path FolderOf(const std::string& path)
{
  const fs::path folder = fs::path(path).parent_path();
  return folder.empty() ? fs::path(".") : folder;
}

std::string NewPartOf(const std::string& path)
{
  static std::atomic<unsigned> count = 0;
  const std::string name =
    partPrefix + std::to_string(getpid()) + '-' + std::to_string(++count) + partMark;
  return (FolderOf(path) / name).string() + fs::path(path).extension().string();
}

void DeleteLeftFiles(const fs::path& folder)
{
  std::error_code error;
  for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator();
       entry.increment(error))
  {
    const std::string name = entry->path().filename().string();
    if (name.compare(0, partPrefix.size(), partPrefix) == 0 &&
      name.find(partMark) != std::string::npos)
    {
      DeleteUnlessLocked(entry->path());
      DeleteFolderUnlessLocked(entry->path());
    }
  }
}

void SyncFolder(const fs::path& folder)
{
  const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor >= 0)
  {
    fsync(descriptor);
    close(descriptor);
  }
}

}
