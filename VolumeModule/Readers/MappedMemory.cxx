#include "Readers/MappedMemory.h"

#include <fcntl.h>
#include <pthread.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <new>
#include <thread>

namespace varimarch
{
namespace
{

/// The bits that /proc/self/pagemap has for a page, see Linux's
/// Documentation/admin-guide/mm/pagemap.rst.
constexpr std::uint64_t IsPresent = 1ull << 63;
constexpr std::uint64_t IsSwapped = 1ull << 62;
constexpr std::uint64_t IsOfFile = 1ull << 61;

struct Kept
{
  std::shared_ptr<MappedFile> file;
  MappedParts parts;
  std::uint64_t mostBytes;
};

/// The files of the process, and the thread that keeps them within their bound.
class MappedFiles
{
public:
  void* Add(std::unique_ptr<MappedFile> newFile, std::uint64_t mostBytes)
  {
    const std::lock_guard<std::mutex> lock(this->mutex);
    std::shared_ptr<MappedFile> file = std::move(newFile);
    this->files.push_back({ file, MappedParts(file), mostBytes });
    if (!this->watcher.joinable())
    {
      this->watcher = std::thread([this] { this->Watch(); });
    }
    return file->Bytes();
  }

  void Remove(void* bytes)
  {
    {
      const std::lock_guard<std::mutex> lock(this->mutex);
      this->files.erase(std::remove_if(this->files.begin(), this->files.end(),
                          [&](const Kept& kept) { return kept.file->Holds(bytes); }),
        this->files.end());
    }
    this->StopIfEmpty();
  }

  std::shared_ptr<MappedFile> At(const void* address)
  {
    const std::lock_guard<std::mutex> lock(this->mutex);
    for (const Kept& kept : this->files)
    {
      if (kept.file->Holds(address))
      {
        return kept.file;
      }
    }
    return nullptr;
  }

  void SetMostBytes(const MappedFile& file, std::uint64_t mostBytes)
  {
    const std::lock_guard<std::mutex> lock(this->mutex);
    for (Kept& kept : this->files)
    {
      kept.mostBytes = kept.file.get() == &file ? mostBytes : kept.mostBytes;
    }
  }

  /// Threads that use the files would leave them locked in a process that is forked meanwhile.
  void PrepareFork() { this->mutex.lock(); }
  void EndForkInParent() { this->mutex.unlock(); }

  /// A process that was forked has no watcher, but remembers that of its parent.
  void EndForkInChild()
  {
    if (this->watcher.joinable())
    {
      this->watcher.detach();
    }
    new (&this->wake) std::condition_variable;
    this->mutex.unlock();
  }

private:
  void StopIfEmpty()
  {
    std::thread ending;
    {
      const std::lock_guard<std::mutex> lock(this->mutex);
      if (this->files.empty())
      {
        ending.swap(this->watcher);
      }
    }
    this->wake.notify_all();
    if (ending.joinable())
    {
      ending.join();
    }
  }

  /// Ends when this thread is no longer the watcher. A flag would not do: a file that is added
  /// while the last one is removed starts another watcher, for which the flag would be unset again.
  void Watch()
  {
    constexpr auto Pause = std::chrono::milliseconds(10);
    std::unique_lock<std::mutex> lock(this->mutex);
    while (this->watcher.get_id() == std::this_thread::get_id())
    {
      this->DropWhatIsTooMuch();
      this->wake.wait_for(lock, Pause);
    }
  }

  void DropWhatIsTooMuch()
  {
    std::uint64_t most = UINT64_MAX;
    for (const Kept& kept : this->files)
    {
      most = std::min(most, kept.mostBytes);
    }
    const std::uint64_t resident = ResidentBytes();
    // An eighth of room, so that the parts are not looked at for every page.
    constexpr std::uint64_t RoomPart = 8;
    const std::uint64_t begins = most - most / RoomPart;
    if (resident > begins)
    {
      this->Drop(resident - std::min(resident, begins - most / RoomPart));
    }
  }

  void Drop(std::uint64_t wantedBytes)
  {
    ++this->now;
    const PageMap pages;
    std::vector<MappedParts::Part> all;
    for (Kept& kept : this->files)
    {
      kept.parts.Look(pages, this->now);
      const auto& parts = kept.parts.Parts();
      std::copy_if(parts.begin(), parts.end(), std::back_inserter(all),
        [](const MappedParts::Part& part) { return part.residentBytes > 0; });
    }
    std::stable_sort(all.begin(), all.end(),
      [](const MappedParts::Part& one, const MappedParts::Part& other)
      { return one.grew < other.grew; });
    std::uint64_t dropped = 0;
    for (auto part = all.begin(); part != all.end() && dropped < wantedBytes; ++part)
    {
      // The part may have been written since the look at all of them, which takes a while.
      const std::size_t bytes = pages.DroppableBytes(part->begin, part->byteCount);
      if (bytes > 0)
      {
        madvise(part->begin, part->byteCount, MADV_DONTNEED);
        dropped += bytes;
      }
    }
  }

  std::mutex mutex;
  std::condition_variable wake;
  std::vector<Kept> files;
  std::thread watcher;
  std::uint64_t now = 0;
};

// They are never destroyed, because an array of mapped voxels may outlive any other object.
MappedFiles& AllFiles()
{
  static MappedFiles& files = *std::make_unique<MappedFiles>().release();
  [[maybe_unused]] static const int forks = pthread_atfork(
    [] { files.PrepareFork(); }, [] { files.EndForkInParent(); }, [] { files.EndForkInChild(); });
  return files;
}

}

std::uint64_t ResidentBytes()
{
  unsigned long long all = 0;
  unsigned long long resident = 0;
  if (std::FILE* const file = std::fopen("/proc/self/statm", "r"))
  {
    if (std::fscanf(file, "%llu %llu", &all, &resident) != 2)
    {
      resident = 0;
    }
    std::fclose(file);
  }
  return resident * std::uint64_t(sysconf(_SC_PAGESIZE));
}

void* KeepMapped(std::unique_ptr<MappedFile> file, std::uint64_t mostBytes)
{
  return AllFiles().Add(std::move(file), mostBytes);
}

void SetMostBytes(const MappedFile& file, std::uint64_t mostBytes)
{
  AllFiles().SetMostBytes(file, mostBytes);
}

void ReleaseMapped(void* bytes)
{
  AllFiles().Remove(bytes);
}

std::shared_ptr<MappedFile> MappedFileAt(const void* address)
{
  return AllFiles().At(address);
}

MappedParts::MappedParts(std::shared_ptr<MappedFile> newFile)
  : file(std::move(newFile))
{
  const std::size_t all = this->file->PageBytes();
  for (std::size_t begin = 0; begin < all; begin += PartBytes)
  {
    this->parts.push_back({ this->file->Pages() + begin, std::min(PartBytes, all - begin), 0, 0 });
  }
}

PageMap::PageMap()
  : descriptor(open("/proc/self/pagemap", O_RDONLY | O_CLOEXEC))
{
}

PageMap::~PageMap()
{
  if (this->descriptor >= 0)
  {
    close(this->descriptor);
  }
}

std::size_t PageMap::DroppableBytes(const char* begin, std::size_t byteCount) const
{
  const auto page = std::size_t(sysconf(_SC_PAGESIZE));
  std::vector<std::uint64_t> entries(byteCount / page);
  const auto place = off_t(reinterpret_cast<std::uintptr_t>(begin) / page * sizeof(entries[0]));
  const std::size_t wanted = entries.size() * sizeof(entries[0]);
  if (pread(this->descriptor, entries.data(), wanted, place) != ssize_t(wanted))
  {
    return 0;
  }
  const bool isWritten = std::any_of(entries.begin(), entries.end(),
    [](std::uint64_t entry)
    { return (entry & (IsPresent | IsSwapped)) != 0 && (entry & IsOfFile) == 0; });
  const auto present = std::size_t(std::count_if(
    entries.begin(), entries.end(), [](std::uint64_t entry) { return (entry & IsPresent) != 0; }));
  return isWritten ? 0 : page * present;
}

void MappedParts::Look(const PageMap& pages, std::uint64_t now)
{
  for (Part& part : this->parts)
  {
    const std::size_t resident = pages.DroppableBytes(part.begin, part.byteCount);
    part.grew = resident > part.residentBytes ? now : part.grew;
    part.residentBytes = resident;
  }
}

}
