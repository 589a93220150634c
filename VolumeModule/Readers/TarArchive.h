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
  std::unique_ptr<ByteStream> stream; ///< at the first byte of the member
  std::uint64_t byteCount;
};

/// Walks through an archive, plain or gzipped, to the first file of that name in any folder.
/// @throws std::runtime_error when it is no tar archive, or has no such file
TarMember FindInTar(const std::string& path, const std::string& name);

}

#endif
