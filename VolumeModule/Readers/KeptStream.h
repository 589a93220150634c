#ifndef Varimarch_Readers_KeptStream_h
#define Varimarch_Readers_KeptStream_h

#include "Readers/ByteStream.h"

#include <cstdint>
#include <memory>
#include <string>

namespace varimarch
{

/// The open stream behind the voxels of a compressed file that were read last. Whoever reads the
/// volumes of a file in their order with it decompresses the file only once.
class KeptStream
{
public:
  /// A stream at a position: the kept one, if it has not passed that yet, or a new one.
  /// @param offset  first byte of the file to decompress
  /// @param position  decompressed bytes before the first to read
  std::unique_ptr<ByteStream> TakeAt(
    const std::string& path, Compression compression, std::uint64_t offset, std::uint64_t position);

  /// Keeps a stream of TakeAt, which is now at a position.
  void Keep(const std::string& path, std::uint64_t offset, std::uint64_t position,
    std::unique_ptr<ByteStream> stream);

private:
  std::string path;
  std::uint64_t offset = 0;
  std::uint64_t position = 0;
  std::unique_ptr<ByteStream> stream;
};

}

#endif
