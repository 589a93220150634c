#ifndef Varimarch_Readers_Packed_ByteStream_h
#define Varimarch_Readers_Packed_ByteStream_h

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

namespace varimarch
{

/// A stream of a file's bytes, decompressed if necessary.
class ByteStream
{
public:
  virtual ~ByteStream() = default;

  /// Fills the buffer; returns less than `count` bytes only at the end.
  /// @returns the number of bytes
  /// @throws std::runtime_error if a compressed stream is corrupt or reading fails
  virtual std::size_t Read(void* buffer, std::size_t count) = 0;

  /// Number of the file's bytes that have been read so far.
  virtual std::uint64_t FileBytes() = 0;

  /// Skips bytes. @returns the number of skipped bytes, at most `count`
  std::uint64_t Skip(std::uint64_t count);
};

enum class Compression
{
  None,
  Deflate,    ///< gzip or zlib, detected from the first bytes
  Other,      ///< bzip2, xz or Zstandard, detected from the first bytes
  Hexadecimal ///< two digits for each byte, which makes a file longer
};

/// The compression of a file as its first bytes show it; zlib streams count as uncompressed, since
/// they have no reliable mark.
Compression CompressionOf(const std::string& path);

/// Opens an existing file (see ReadableFileSize).
/// @param offset  first byte to read, before any decompression
std::unique_ptr<ByteStream> OpenStream(
  const std::string& path, Compression compression, std::uint64_t offset = 0);

/// OpenStream for Compression::Other. libarchive decompresses, so a module asks a decoder.
std::unique_ptr<ByteStream> OpenArchiveStream(const std::string& path, std::uint64_t offset);

/// Upper bound of the compression ratio of deflate; a header that promises more is false. The
/// method's limit is 1032, see zlib's technical notes; the rest allows for headers.
constexpr double LargestDeflateRatio = 1040.0;

/// Upper bound of the ratio of a stream's size to that of the file.
double LargestRatio(Compression compression);

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
