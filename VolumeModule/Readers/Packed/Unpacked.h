#ifndef Varimarch_Readers_Packed_Unpacked_h
#define Varimarch_Readers_Packed_Unpacked_h

#include "Readers/Packed/PrivateFolder.h"
#include "Readers/VolumeFile.h"

#include <memory>
#include <string>
#include <vector>

namespace varimarch
{

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
  PrivateFolder folder;
  std::string original;
  std::string copies;
};

/// The copies of a path that cannot be read as it is; null for other paths.
std::unique_ptr<Unpacked> UnpackedIfPacked(
  const std::string& path, std::vector<std::string>& warnings, ReadProgress& progress);

}

#endif
