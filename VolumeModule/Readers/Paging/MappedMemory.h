#ifndef Varimarch_Readers_Paging_MappedMemory_h
#define Varimarch_Readers_Paging_MappedMemory_h

#include "Core/Fields/VolumeSummary.h"
#include "Readers/Paging/PagedVoxels.h"

#include <cstddef>
#include <cstdint>
#include <memory>

namespace varimarch
{

/// The number of bytes of a page of memory.
std::size_t PageBytes();

/// The pages of this process, as the system lists them.
class PageMap
{
public:
  PageMap();
  ~PageMap();
  PageMap(const PageMap&) = delete;
  void operator=(const PageMap&) = delete;

  /// Memory that dropping a part of a mapped file would free; 0 if this would lose pages that were
  /// written, or if the system does not tell.
  /// @param byteCount  whole pages
  std::size_t DroppableBytes(const char* begin, std::size_t byteCount) const;

private:
  int descriptor;
};

/// Puts voxels among those whose pages are kept within a bound: while the process has more than
/// `mostBytes` in memory, a thread drops parts of them, but not the quarter in which a page is
/// newest while there are others. Rays wait at the ReadingGate meanwhile. What is dropped is read
/// again when it is needed. Parts that were written are kept, but not what is first written to a
/// part in the instant in which it is dropped. Where several volumes have a bound, the least one
/// counts. The thread ends with the last of them.
/// @return the bytes of the voxels; ReleasePaged(bytes) is called when nobody uses them any more
void* KeepPaged(std::unique_ptr<PagedVoxels> voxels, std::uint64_t mostBytes);

/// Changes the bound of voxels of KeepPaged.
void SetMostBytes(const PagedVoxels& voxels, std::uint64_t mostBytes);

/// The bound of voxels of KeepPaged; 0 for others.
std::uint64_t MostBytesOf(const PagedVoxels& voxels);

void ReleasePaged(void* bytes);

}

class vtkDataArray;

namespace varimarch
{

/// The paged voxels that are these scalars; null for scalars in memory.
std::shared_ptr<PagedVoxels> PagedVoxelsOf(vtkDataArray* scalars);

/// The summary of scalars that stayed on disk; null for others, and once they are modified.
std::shared_ptr<const VolumeSummary> SummaryOf(vtkDataArray* scalars);

}

#endif
