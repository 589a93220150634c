#ifndef Varimarch_Readers_ByteStream_h
#define Varimarch_Readers_ByteStream_h

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

namespace varimarch
{

/// Bytes of a file, one after another, decompressed on the way when need be.
class ByteStream
{
public:
  virtual ~ByteStream() = default;

  /// Fills the buffer; less than `count` bytes only at the end.
  /// @returns the number of bytes
  /// @throws std::runtime_error for a corrupt compressed stream or a failing disk
  virtual std::size_t Read(void* buffer, std::size_t count) = 0;

  /// Passes over bytes. @returns how many there were, at most `count`
  std::uint64_t Skip(std::uint64_t count);
};

enum class Compression
{
  None,
  Deflate ///< gzip or zlib, whichever the stream begins with
};

/// Deflate for a file that begins as gzip does.
Compression CompressionOf(const std::string& path);

/// Opens a file that exists (see ReadableFileSize).
/// @param offset  of the first byte to take from the file, before any decompression
std::unique_ptr<ByteStream> OpenStream(
  const std::string& path, Compression compression, std::uint64_t offset = 0);

/// No deflate stream holds more than this many times its own size, so a promise of more is false.
/// (1032 is the limit of the method, see zlib's technical notes; the rest is for headers.)
constexpr double LargestDeflateRatio = 1040.0;

}

#endif
