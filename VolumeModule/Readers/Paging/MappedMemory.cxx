#include "Readers/Paging/MappedMemory.h"

#include "Core/Blocks/ReadingGate.h"

#include <vtkDataArray.h>

#include <fcntl.h>
#include <pthread.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <new>
#include <random>
#include <thread>
#include <utility>
#include <vector>

namespace varimarch
{
namespace
{

/// The bits that /proc/self/pagemap has for a page, see Linux's
/// Documentation/admin-guide/mm/pagemap.rst.
constexpr std::uint64_t IsPresent = 1ull << 63;
constexpr std::uint64_t IsSwapped = 1ull << 62;
constexpr std::uint64_t IsOfFile = 1ull << 61;

}

std::size_t PageBytes()
{
  static const auto bytes = std::size_t(sysconf(_SC_PAGESIZE));
  return bytes;
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
  const std::size_t page = PageBytes();
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

namespace
{

struct Kept
{
  std::shared_ptr<PagedVoxels> voxels;
  std::uint64_t mostBytes;
};

/// The paged voxels of the process, and the thread that keeps them within their bound.
class AllKept
{
public:
  void* Add(std::unique_ptr<PagedVoxels> voxels, std::uint64_t mostBytes)
  {
    const std::lock_guard<std::mutex> lock(this->mutex);
    void* const bytes = voxels->Bytes();
    this->all.push_back({ std::move(voxels), mostBytes });
    if (!this->watcher.joinable())
    {
      this->watcher = std::thread([this] { this->Watch(); });
    }
    return bytes;
  }

  /// The voxels end without the lock, since they may wait for a thread that starts a process.
  void Remove(void* bytes)
  {
    std::vector<Kept> removed;
    {
      const std::lock_guard<std::mutex> lock(this->mutex);
      this->Move([&](const Kept& kept) { return kept.voxels->Holds(bytes); }, removed);
    }
    this->StopIfEmpty();
  }

  std::shared_ptr<PagedVoxels> At(const void* address)
  {
    const std::lock_guard<std::mutex> lock(this->mutex);
    for (const Kept& kept : this->all)
    {
      if (kept.voxels->Holds(address))
      {
        return kept.voxels;
      }
    }
    return nullptr;
  }

  void SetMostBytes(const PagedVoxels& voxels, std::uint64_t mostBytes)
  {
    const std::lock_guard<std::mutex> lock(this->mutex);
    for (Kept& kept : this->all)
    {
      kept.mostBytes = kept.voxels.get() == &voxels ? mostBytes : kept.mostBytes;
    }
  }

  std::uint64_t MostBytesOf(const PagedVoxels& voxels)
  {
    const std::lock_guard<std::mutex> lock(this->mutex);
    const auto found = std::find_if(this->all.begin(), this->all.end(),
      [&](const Kept& kept) { return kept.voxels.get() == &voxels; });
    return found == this->all.end() ? 0 : found->mostBytes;
  }

  /// Threads that use the voxels would leave them locked in a process that is forked meanwhile.
  void PrepareFork() { this->mutex.lock(); }
  void EndForkInParent() { this->mutex.unlock(); }

  /// A process that was forked has no watcher, but remembers that of its parent. It may have other
  /// memory where voxels are missing, and must not end the threads of its parent that read them.
  void EndForkInChild()
  {
    this->Move(
      [](const Kept& kept) { return !kept.voxels->AreInForkedProcesses(); }, this->ofParent);
    if (this->watcher.joinable())
    {
      this->watcher.detach();
    }
    new (&this->wake) std::condition_variable;
    ReadingGate::OfProcess().Open();
    this->mutex.unlock();
  }

private:
  /// Moves the voxels for which a condition is true.
  template <class Condition>
  void Move(Condition isMoved, std::vector<Kept>& to)
  {
    const auto moved = std::stable_partition(
      this->all.begin(), this->all.end(), [&](const Kept& kept) { return !isMoved(kept); });
    to.insert(to.end(), moved, this->all.end());
    this->all.erase(moved, this->all.end());
  }

  void StopIfEmpty()
  {
    std::thread ending;
    {
      const std::lock_guard<std::mutex> lock(this->mutex);
      if (this->all.empty())
      {
        ending.swap(this->watcher);
        ReadingGate::OfProcess().Open();
      }
    }
    this->wake.notify_all();
    if (ending.joinable())
    {
      ending.join();
    }
  }

  /// Ends when this thread is no longer the watcher. A flag would not do: voxels that are
  /// added while the last are removed start another watcher, for which the flag would be unset.
  void Watch()
  {
    constexpr auto Pause = std::chrono::milliseconds(10);
    constexpr auto PauseWithRays = std::chrono::milliseconds(1);
    ReadingGate& gate = ReadingGate::OfProcess();
    std::unique_lock<std::mutex> lock(this->mutex);
    while (this->watcher.get_id() == std::this_thread::get_id())
    {
      this->DropWhatIsTooMuch();
      const auto end = std::chrono::steady_clock::now() + Pause;
      do
      {
        this->wake.wait_for(lock, gate.IsInUse() ? PauseWithRays : Pause);
      } while (!gate.IsClosed() && std::chrono::steady_clock::now() < end &&
        this->watcher.get_id() == std::this_thread::get_id());
    }
  }

  void DropWhatIsTooMuch()
  {
    std::uint64_t most = UINT64_MAX;
    for (const Kept& kept : this->all)
    {
      most = std::min(most, kept.mostBytes);
    }
    const std::uint64_t resident = ResidentBytes();
    // A drop frees this much, so that the parts are not looked at for every page.
    const std::uint64_t room = most / 8;
    // Rays look again after each packet, which brings up to some hundred megabytes meanwhile.
    const std::uint64_t begins = most - room - most / 16;
    std::uint64_t holds = begins;
    if (resident > begins)
    {
      this->Drop(resident - std::min(resident, begins - room));
      // There is room for rays even if too little could be dropped.
      constexpr std::uint64_t LeastRoom = 64 << 20;
      holds = std::max(begins, ResidentBytes() + std::max(room, LeastRoom));
    }
    ReadingGate::OfProcess().OpenUntil(holds);
  }

  void Drop(std::uint64_t wantedBytes)
  {
    const PageMap map;
    std::uint64_t dropped = 0;
    std::uint64_t ofLook = 1;
    while (dropped < wantedBytes && ofLook > 0)
    {
      ofLook = this->DropOfLook(wantedBytes - dropped, map);
      dropped += ofLook;
    }
  }

  /// Drops some of the parts that one look at the voxels finds, but not the quarter in which a page
  /// is newest while there are others.
  std::uint64_t DropOfLook(std::uint64_t wantedBytes, const PageMap& map)
  {
    struct PartOfAny
    {
      PagedVoxels* voxels;
      PagedVoxels::Part part;
    };
    const auto now = std::uint64_t(std::chrono::steady_clock::now().time_since_epoch().count());
    std::vector<PartOfAny> parts;
    for (const Kept& kept : this->all)
    {
      for (const PagedVoxels::Part& part : kept.voxels->DroppableParts(map, now))
      {
        parts.push_back({ kept.voxels.get(), part });
      }
    }
    std::stable_sort(parts.begin(), parts.end(),
      [](const PartOfAny& one, const PartOfAny& other) { return one.part.grew < other.part.grew; });
    // An image needs about the same parts as the one before, in the same order: if they do not fit,
    // the oldest are those that are needed next. Chance keeps most of them.
    const auto newest = parts.end() - std::ptrdiff_t(parts.size() / 4);
    std::shuffle(parts.begin(), newest, this->chance);
    std::uint64_t dropped = 0;
    for (auto next = parts.begin(); next != newest && dropped < wantedBytes; ++next)
    {
      dropped += next->voxels->Drop(next->part.index, map);
    }
    return dropped;
  }

  std::mutex mutex;
  std::condition_variable wake;
  std::vector<Kept> all;
  std::vector<Kept> ofParent; ///< in a process that was forked: voxels that it does not have
  std::thread watcher;
  std::minstd_rand chance;
};

// They are never destroyed, because an array of paged voxels may outlive any other object.
AllKept& All()
{
  static AllKept& all = *std::make_unique<AllKept>().release();
  [[maybe_unused]] static const int forks = pthread_atfork(
    [] { all.PrepareFork(); }, [] { all.EndForkInParent(); }, [] { all.EndForkInChild(); });
  return all;
}

}

void* KeepPaged(std::unique_ptr<PagedVoxels> voxels, std::uint64_t mostBytes)
{
  return All().Add(std::move(voxels), mostBytes);
}

void SetMostBytes(const PagedVoxels& voxels, std::uint64_t mostBytes)
{
  All().SetMostBytes(voxels, mostBytes);
}

std::uint64_t MostBytesOf(const PagedVoxels& voxels)
{
  return All().MostBytesOf(voxels);
}

void ReleasePaged(void* bytes)
{
  All().Remove(bytes);
}

std::shared_ptr<PagedVoxels> PagedVoxelsAt(const void* address)
{
  return All().At(address);
}

std::shared_ptr<PagedVoxels> PagedVoxelsOf(vtkDataArray* scalars)
{
  return PagedVoxelsAt(scalars->GetVoidPointer(0));
}

std::shared_ptr<const VolumeSummary> SummaryOf(vtkDataArray* scalars)
{
  const auto voxels = PagedVoxelsOf(scalars);
  return voxels ? voxels->Summary(scalars->GetMTime()) : nullptr;
}

}
