#include "Readers/Packed/PrivateFolder.h"

#include "Readers/FileError.h"
#include "Readers/VoxelLayout.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>

namespace varimarch
{
namespace
{

namespace fs = std::filesystem;

const std::string prefix = "varimarch-copies-";

double FreeBytesAt(const fs::path& place)
{
  std::error_code error;
  const fs::space_info space = fs::space(place, error);
  return error ? 0.0 : double(space.available);
}

/// The folder that holds the private ones.
fs::path Place()
{
  // This file system is in memory. Containers often give it only 64 MB.
  const fs::path memory = "/dev/shm";
  const bool isUsable =
    access(memory.c_str(), W_OK) == 0 && FreeBytesAt(memory) > 0.25 * PhysicalMemoryBytes();
  return isUsable ? memory : fs::temp_directory_path();
}

/// Opens and locks a folder of this user; -1 if it is another's, or another process has locked it.
int LockedFolder(const fs::path& folder)
{
  const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  struct stat status = {};
  if (descriptor >= 0 && fstat(descriptor, &status) == 0 && status.st_uid == geteuid() &&
    flock(descriptor, LOCK_EX | LOCK_NB) == 0)
  {
    return descriptor;
  }
  if (descriptor >= 0)
  {
    close(descriptor);
  }
  return -1;
}

/// Deletes the folders of processes that have ended.
void DeleteLeftFolders(const fs::path& place)
{
  std::error_code error;
  for (fs::directory_iterator entry(place, error); !error && entry != fs::directory_iterator();
       entry.increment(error))
  {
    const bool isOurs = entry->path().filename().string().compare(0, prefix.size(), prefix) == 0;
    const int descriptor = isOurs ? LockedFolder(entry->path()) : -1;
    if (descriptor >= 0)
    {
      std::error_code ignored;
      fs::remove_all(entry->path(), ignored);
      close(descriptor);
    }
  }
}

}

PrivateFolder::PrivateFolder()
{
  const fs::path place = Place();
  DeleteLeftFolders(place);
  // Another process may delete the new folder before it is locked.
  for (int trial = 0; trial < 10 && this->lock < 0; ++trial)
  {
    std::string name = (place / (prefix + "XXXXXX")).string();
    if (!mkdtemp(name.data()))
    {
      FailToRead(place.string(), "a folder for temporary files",
        std::string("the error \"") + std::strerror(errno) + '"');
    }
    this->path = name;
    this->lock = LockedFolder(this->path);
  }
}

PrivateFolder::~PrivateFolder()
{
  std::error_code ignored;
  fs::remove_all(this->path, ignored);
  close(this->lock);
}

double PrivateFolder::FreeBytes() const
{
  return std::min(FreeMemoryBytes(), FreeBytesAt(this->path));
}

}
