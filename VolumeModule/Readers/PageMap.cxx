#include "Readers/PageMap.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
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

}
