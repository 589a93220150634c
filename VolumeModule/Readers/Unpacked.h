#ifndef Varimarch_Readers_Unpacked_h
#define Varimarch_Readers_Unpacked_h

#include "Readers/PrivateFolder.h"
#include "Readers/VolumeFile.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

struct archive_entry;

namespace varimarch
{

class ArchiveInput;

/// True for the first bytes, decompressed, of an archive that Unpacked opens: tar or ZIP.
bool IsArchive(const std::string& head);

/// Plain copies of what is packed: of the files in an archive, of a compressed file, or of a folder
/// with compressed files. They exist as long as this object.
class Unpacked
{
public:
  /// Unpacks. Links, and files whose paths lead out of their archive, are left out.
  /// @param warnings  receives a sentence about what was left out
  /// @throws std::runtime_error if the content is corrupt, encrypted, or does not fit in the free
  /// memory
  /// @throws ReadCancelled
  Unpacked(const std::string& path, std::vector<std::string>& warnings, ReadProgress& progress);

  /// The file or folder to read in place of the packed one.
  const std::string& Path() const { return this->copies; }

  /// A message with paths of the copies replaced by those of the packed files.
  std::string WithOriginalPaths(std::string message) const;

private:
  /// Fills a buffer; returns less than `count` bytes only at the end.
  using Source = std::function<std::size_t(void* buffer, std::size_t count)>;

  void UnpackArchive(std::vector<std::string>& warnings, ReadProgress& progress);
  void UnpackEntry(ArchiveInput& input, archive_entry* entry, const std::string& to,
    const std::function<void()>& report);
  void UnpackFile(const std::string& from, const std::string& to, ReadProgress& progress);
  void UnpackFolder(ReadProgress& progress);
  void Write(const std::string& to, const Source& source, const std::function<void()>& report);
  void CheckSpace(double byteCount) const;

  PrivateFolder folder;
  std::string original;
  std::string copies;
  double spaceBytes; ///< space for copies
  double usedBytes = 0.0;
};

/// The copies of a path that cannot be read as it is; null for other paths.
std::unique_ptr<Unpacked> UnpackedIfPacked(
  const std::string& path, std::vector<std::string>& warnings, ReadProgress& progress);

}

#endif
