#include "Readers/MappedFile.h"

#include "Readers/FileError.h"
#include "Readers/PageGuard.h"
#include "Readers/PageMap.h"
#include "Readers/VoxelLayout.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace varimarch
{
namespace
{

std::int64_t NanosecondsOf(const timespec& time)
{
  return std::int64_t(time.tv_sec) * 1000000000 + time.tv_nsec;
}

}

MappedFile::MappedFile(const std::string& path, std::uint64_t offset, std::uint64_t byteCount)
  : path(path)
  , size(ReadableFileSize(path))
{
  if (offset + byteCount > this->size)
  {
    FailToRead(path, std::to_string(offset + byteCount) + " bytes", std::to_string(this->size));
  }
  this->descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  struct stat status = {};
  if (this->descriptor < 0 || fstat(this->descriptor, &status) != 0)
  {
    FailToRead(path, "a file that can be opened", std::strerror(errno));
  }
  this->modified = NanosecondsOf(status.st_mtim);
  const std::uint64_t page = PageBytes();
  this->lead = std::size_t(offset % page);
  this->pageBytes = (std::size_t(byteCount) + this->lead + page - 1) / page * page;
  void* const mapped = mmap(nullptr, this->pageBytes, PROT_READ | PROT_WRITE,
    MAP_PRIVATE | MAP_NORESERVE, this->descriptor, off_t(offset - this->lead));
  this->pages = static_cast<char*>(mapped);
  this->guard = mapped == MAP_FAILED
    ? -1
    : GuardPages(this->pages, this->pageBytes, this->descriptor, std::size_t(offset - this->lead));
  if (this->guard < 0)
  {
    const std::string reason = mapped == MAP_FAILED ? std::strerror(errno) : "too many others";
    if (mapped != MAP_FAILED)
    {
      munmap(mapped, this->pageBytes);
    }
    close(this->descriptor);
    FailToRead(
      path, "a file whose " + ByteText(double(byteCount)) + " of voxels can be mapped", reason);
  }
  this->looks.resize((this->pageBytes + PartBytes - 1) / PartBytes);
}

MappedFile::~MappedFile()
{
  GuardNoMore(this->guard);
  munmap(this->pages, this->pageBytes);
  close(this->descriptor);
}

std::size_t MappedFile::BytesOfPart(std::size_t index) const
{
  return std::min(PartBytes, this->pageBytes - index * PartBytes);
}

std::vector<PagedVoxels::Part> MappedFile::DroppableParts(const PageMap& map, std::uint64_t now)
{
  std::vector<Part> parts;
  this->nextLook = (this->nextLook + 1) % LooksPerRound;
  for (std::size_t i = this->nextLook; i < this->looks.size(); i += LooksPerRound)
  {
    Look& look = this->looks[i];
    const std::size_t resident =
      map.DroppableBytes(this->pages + i * PartBytes, this->BytesOfPart(i));
    look.grew = resident > look.residentBytes ? now : look.grew;
    look.residentBytes = resident;
    if (resident > 0)
    {
      parts.push_back({ i, resident, look.grew });
    }
  }
  return parts;
}

// The part may have been written since the look at all of them, which takes a while.
std::size_t MappedFile::Drop(std::size_t index, const PageMap& map)
{
  char* const begin = this->pages + index * PartBytes;
  const std::size_t bytes = map.DroppableBytes(begin, this->BytesOfPart(index));
  if (bytes > 0)
  {
    madvise(begin, this->BytesOfPart(index), MADV_DONTNEED);
  }
  return bytes;
}

std::string MappedFile::Problem() const
{
  const std::string begin = "The file " + Quoted(this->path, 200);
  struct stat status = {};
  const bool isKnown = fstat(this->descriptor, &status) == 0;
  if (isKnown && std::uint64_t(status.st_size) < this->size)
  {
    return begin + " was made shorter while it is drawn from disk: expected " +
      std::to_string(this->size) + " bytes, found " + std::to_string(status.st_size) +
      "; voxels that are missing count as 0. Open it again when it is complete";
  }
  if (HasReplacedPages(this->guard))
  {
    return begin +
      " could not be read everywhere: voxels that are missing count as 0. Check its "
      "disk, and open it again";
  }
  if (!isKnown || NanosecondsOf(status.st_mtim) != this->modified)
  {
    return begin +
      " was changed while it is drawn from disk, so that the image may mix old and "
      "new voxels. Open it again";
  }
  return "";
}

}
