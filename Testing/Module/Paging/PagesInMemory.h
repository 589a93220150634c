#ifndef Varimarch_Testing_PagesInMemory_h
#define Varimarch_Testing_PagesInMemory_h

#include <vtkImageData.h>

#include <gtest/gtest.h>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

/// The number of pages of an image's voxels that this process can read without a fault.
inline std::size_t PagesThere(vtkImageData* image)
{
  constexpr std::uint64_t IsPresent = std::uint64_t(1) << 63; // a bit of /proc/self/pagemap
  const auto page = std::uint64_t(sysconf(_SC_PAGESIZE));
  const auto first = std::uint64_t(reinterpret_cast<std::uintptr_t>(image->GetScalarPointer()));
  const auto bytes = std::uint64_t(image->GetNumberOfPoints()) * image->GetScalarSize();
  std::vector<std::uint64_t> entries((first + bytes - 1) / page - first / page + 1);
  // Only reads of whole entries are allowed.
  const int map = open("/proc/self/pagemap", O_RDONLY | O_CLOEXEC);
  const std::size_t wanted = entries.size() * sizeof(entries[0]);
  EXPECT_EQ(
    pread(map, entries.data(), wanted, off_t(first / page * sizeof(entries[0]))), ssize_t(wanted));
  close(map);
  return std::size_t(std::count_if(
    entries.begin(), entries.end(), [](std::uint64_t entry) { return (entry & IsPresent) != 0; }));
}

/// The memory of the mapping that an image's voxels begin in [bytes]. The system's page of zeros
/// needs none.
inline std::size_t MemoryOfMapping(vtkImageData* image)
{
  const auto first = std::uint64_t(reinterpret_cast<std::uintptr_t>(image->GetScalarPointer()));
  std::ifstream mappings("/proc/self/smaps");
  bool isFound = false;
  for (std::string line; std::getline(mappings, line);)
  {
    unsigned long long begin = 0;
    unsigned long long end = 0;
    unsigned long long kilobytes = 0;
    if (std::sscanf(line.c_str(), "%llx-%llx ", &begin, &end) == 2)
    {
      isFound = begin <= first && first < end;
    }
    else if (isFound && std::sscanf(line.c_str(), "Rss: %llu kB", &kilobytes) == 1)
    {
      return std::size_t(kilobytes) * 1024;
    }
  }
  ADD_FAILURE() << "the system does not list the mapping";
  return 0;
}

#endif
