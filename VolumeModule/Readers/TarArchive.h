#ifndef Varimarch_Readers_TarArchive_h
#define Varimarch_Readers_TarArchive_h

#include "Readers/ByteStream.h"

#include <cstdint>
#include <memory>
#include <string>

namespace varimarch
{

/// A file in a tar archive, ready to be read.
struct TarMember
{
  std::unique_ptr<ByteStream> stream; ///< positioned at the first byte of the member
  std::uint64_t byteCount;
};

/// Finds the first file with the given name, in any folder of an archive that may be gzipped.
/// @throws std::runtime_error if it is not a tar archive, or has no such file
TarMember FindInTar(const std::string& path, const std::string& name);

}

#endif
