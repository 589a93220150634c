#include "Readers/PageGuard.h"

#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <mutex>

namespace varimarch
{
namespace
{

/// Only atomic numbers, since a signal's action may interrupt anything.
struct GuardedPages
{
  std::atomic<std::uintptr_t> begin = 0;
  std::atomic<std::uintptr_t> end = 0; ///< 0: not in use
  std::atomic<int> descriptor = -1;
  std::atomic<std::size_t> offset = 0;
  std::atomic<bool> replaced = false;
};

constexpr std::size_t MostGuards = 256;
std::array<GuardedPages, MostGuards> guards;
struct sigaction actionBefore = {};
std::uintptr_t pageSize = 4096;

GuardedPages* GuardOf(std::uintptr_t address)
{
  const auto guard = std::find_if(guards.begin(), guards.end(),
    [&](const GuardedPages& pages) { return address >= pages.begin && address < pages.end; });
  return guard == guards.end() ? nullptr : guard;
}

/// Replaces all pages that a shortened file has lost, or else the one that cannot be read. Calls
/// only functions that are safe in the action of a signal.
bool ReplacePages(GuardedPages& guard, std::uintptr_t address)
{
  const std::uintptr_t page = address / pageSize * pageSize;
  std::uintptr_t from = page;
  std::uintptr_t to = page + pageSize;
  struct stat status = {};
  const bool isKnown = fstat(guard.descriptor, &status) == 0;
  const std::uintptr_t pagesOfFile = (std::uintptr_t(status.st_size) + pageSize - 1) / pageSize;
  const std::uintptr_t firstLost =
    guard.begin + (std::max<std::uintptr_t>(pagesOfFile * pageSize, guard.offset) - guard.offset);
  if (isKnown && firstLost <= page)
  {
    from = firstLost;
    to = guard.end;
  }
  guard.replaced = true;
  return mmap(reinterpret_cast<void*>(from), to - from, PROT_READ | PROT_WRITE,
           MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED | MAP_NORESERVE, -1, 0) != MAP_FAILED;
}

/// An action that ends after restoring the earlier one lets the program meet the same fault again,
/// which then has its usual effect. A signal that another program sent has no address, and would
/// not come again by itself.
void ActOnSignal(int signal, siginfo_t* info, void*)
{
  const int errorBefore = errno;
  const bool isFault = info->si_code > 0;
  const auto address = reinterpret_cast<std::uintptr_t>(info->si_addr);
  GuardedPages* const guard = isFault ? GuardOf(address) : nullptr;
  if (!guard || !ReplacePages(*guard, address))
  {
    sigaction(signal, &actionBefore, nullptr);
    if (!isFault)
    {
      raise(signal);
    }
  }
  errno = errorBefore;
}

void TakeOverSignal()
{
  pageSize = std::uintptr_t(sysconf(_SC_PAGESIZE));
  struct sigaction action = {};
  action.sa_sigaction = ActOnSignal;
  action.sa_flags = SA_SIGINFO | SA_RESTART | SA_ONSTACK;
  sigemptyset(&action.sa_mask);
  sigaction(SIGBUS, &action, &actionBefore);
}

}

int GuardPages(char* pages, std::size_t byteCount, int descriptor, std::size_t offset)
{
  static std::once_flag once;
  static std::mutex mutex;
  std::call_once(once, TakeOverSignal);
  const std::lock_guard<std::mutex> lock(mutex);
  const auto guard = std::find_if(
    guards.begin(), guards.end(), [](const GuardedPages& candidate) { return candidate.end == 0; });
  if (guard == guards.end())
  {
    return -1;
  }
  guard->descriptor = descriptor;
  guard->offset = offset;
  guard->replaced = false;
  guard->begin = reinterpret_cast<std::uintptr_t>(pages);
  guard->end = reinterpret_cast<std::uintptr_t>(pages) + byteCount;
  return int(guard - guards.begin());
}

bool HasReplacedPages(int guard)
{
  return guards[std::size_t(guard)].replaced;
}

void GuardNoMore(int guard)
{
  guards[std::size_t(guard)].end = 0;
}

}
