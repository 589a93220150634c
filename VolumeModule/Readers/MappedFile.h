#ifndef Varimarch_Readers_MappedFile_h
#define Varimarch_Readers_MappedFile_h

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

namespace varimarch
{

struct VolumeSummary;

/// The bytes of a file in the address space, read from disk when they are touched. They may be
/// written; what is written stays in memory and never reaches the file.
///
/// Bytes that the file has lost since, because it was made shorter or its disk fails, are 0 instead
/// of ending the program; Problem() then says so. MappedMemory keeps what is in memory within a
/// bound.
class MappedFile
{
public:
  /// @param offset  first byte of the file
  /// @throws std::runtime_error if the file is shorter, or cannot be mapped
  MappedFile(const std::string& path, std::uint64_t offset, std::uint64_t byteCount);
  ~MappedFile();
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  void* Bytes() const { return this->pages + this->lead; }
  const std::string& Path() const { return this->path; }

  /// True for an address inside.
  bool Holds(const void* address) const;

  /// The sentence that says what has happened to the file since it was mapped; empty if nothing
  /// has. The full stop is missing.
  std::string Problem() const;

  /// Remembers the facts about the voxels that it holds.
  /// @param time  time of the last change of the array that has them
  void Describe(std::shared_ptr<const VolumeSummary> newSummary, std::uint64_t time);

  /// The facts about the voxels; null if the array has changed since.
  std::shared_ptr<const VolumeSummary> Summary(std::uint64_t time) const;

  /// The part of the address space, in whole pages.
  char* Pages() const { return this->pages; }
  std::size_t PageBytes() const { return this->pageBytes; }

private:
  std::string path;
  std::uint64_t size = 0; ///< size of the file when it was mapped
  std::int64_t modified = 0;
  int descriptor = -1;
  char* pages = nullptr;
  std::size_t pageBytes = 0;
  std::size_t lead = 0; ///< bytes of the first page before the first byte
  std::shared_ptr<const VolumeSummary> summary;
  std::uint64_t summaryTime = 0;
  int guard = -1; ///< number of its entry among the guarded addresses
};

/// The mapped file that an address is in; null if there is none.
std::shared_ptr<MappedFile> MappedFileAt(const void* address);

}

#endif
