#ifndef Varimarch_Readers_MappedMemory_h
#define Varimarch_Readers_MappedMemory_h

#include "Readers/MappedFile.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace varimarch
{

/// Puts a file among those whose pages are kept within a bound: while the process has more than
/// `mostBytes` in memory, a thread drops pages of mapped files, first those of the parts that have
/// gone longest without a new page. What is dropped is read again when it is needed, from the
/// system's cache of the disk or from the disk. Parts with pages that were written are kept, but
/// not what is first written to a part in the instant in which it is dropped. Where several files
/// have a bound, the least one counts. The thread ends with the last file.
/// @return the file's bytes; ReleaseMapped(bytes) is called when nobody uses them any more
void* KeepMapped(std::unique_ptr<MappedFile> file, std::uint64_t mostBytes);

/// Changes the bound of a file of KeepMapped.
void SetMostBytes(const MappedFile& file, std::uint64_t mostBytes);

void ReleaseMapped(void* bytes);

/// Memory of this process that is resident now, with that of mapped files [bytes].
std::uint64_t ResidentBytes();

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

/// Parts of mapped files, as long as an address range that is dropped as a whole, in order of
/// least recent growth.
class MappedParts
{
public:
  static constexpr std::size_t PartBytes = 4 << 20;

  explicit MappedParts(std::shared_ptr<MappedFile> file);

  const MappedFile& File() const { return *this->file; }

  /// Finds out which pages are in memory.
  void Look(const PageMap& pages, std::uint64_t now);

  struct Part
  {
    char* begin;
    std::size_t byteCount;
    std::size_t residentBytes; ///< as PageMap::DroppableBytes
    std::uint64_t grew;        ///< the time when it last had more pages than the time before
  };
  const std::vector<Part>& Parts() const { return this->parts; }

private:
  std::shared_ptr<MappedFile> file;
  std::vector<Part> parts;
};

}

#endif
