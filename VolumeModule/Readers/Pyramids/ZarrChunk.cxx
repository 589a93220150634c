// The compressions of Zarr's chunks. Blosc and LZ4 have libraries of their own; zlib and libarchive
// decompress the others as streams.
#include "Readers/ByteStream.h"
#include "Readers/FileError.h"
#include "Readers/HeaderText.h"
#include "Readers/Pyramids/ZarrHeader.h"

#include <blosc.h>
#include <lz4.h>

#include <cstring>
#include <limits>

namespace varimarch
{
namespace
{

[[noreturn]] void FailToDecompress(
  const std::string& path, const std::string& codec, std::size_t expectedBytes)
{
  FailToRead(path,
    "a chunk of " + std::to_string(expectedBytes) + " bytes that " + codec + " has compressed",
    "a damaged or incomplete one");
}

void DecompressBlosc(const std::string& path, std::vector<char>& chunk)
{
  const std::string packed = WholeFile(path);
  std::size_t chunkBytes = 0;
  const bool isValid = blosc_cbuffer_validate(packed.data(), packed.size(), &chunkBytes) == 0 &&
    chunkBytes == chunk.size();
  constexpr int ThreadCount = 1; // other chunks are decompressed at the same time
  const bool isDone = isValid &&
    blosc_decompress_ctx(packed.data(), chunk.data(), chunk.size(), ThreadCount) ==
      int(chunk.size());
  if (!isDone)
  {
    FailToDecompress(path, "blosc", chunk.size());
  }
}

/// Zarr writes the number of bytes, little endian, before a block of LZ4.
void DecompressLz4(const std::string& path, std::vector<char>& chunk)
{
  const std::string packed = WholeFile(path);
  constexpr std::size_t LengthBytes = 4;
  constexpr auto Most = std::size_t(std::numeric_limits<int>::max());
  const bool fits = packed.size() > LengthBytes && packed.size() <= Most && chunk.size() <= Most;
  const bool isDone = fits &&
    LZ4_decompress_safe(packed.data() + LengthBytes, chunk.data(), int(packed.size() - LengthBytes),
      int(chunk.size())) == int(chunk.size());
  if (!isDone)
  {
    FailToDecompress(path, "lz4", chunk.size());
  }
}

void ReadStream(const std::string& path, const std::string& codec, std::vector<char>& chunk)
{
  const Compression compression = codec.empty() ? Compression::None
    : codec == "zlib" || codec == "gzip"        ? Compression::Deflate
                                                : Compression::Other;
  ReadableFileSize(path);
  const auto stream = OpenStream(path, compression);
  char behind = 0;
  if (stream->Read(chunk.data(), chunk.size()) != chunk.size() || stream->Read(&behind, 1) != 0)
  {
    FailToDecompress(path, codec.empty() ? "nothing" : codec, chunk.size());
  }
}

}

void ReadZarrChunk(const std::string& path, const std::string& codec, std::vector<char>& chunk)
{
  if (codec == "blosc")
  {
    DecompressBlosc(path, chunk);
  }
  else if (codec == "lz4")
  {
    DecompressLz4(path, chunk);
  }
  else
  {
    ReadStream(path, codec, chunk);
  }
}

}
