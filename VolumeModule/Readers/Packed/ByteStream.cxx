#include "Readers/Packed/ByteStream.h"

#include "Readers/FileError.h"

#include <zlib.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <limits>
#include <vector>

namespace varimarch
{
namespace
{

class FileStream : public ByteStream
{
public:
  FileStream(const std::string& path, std::uint64_t offset)
    : path(path)
    , file(path, std::ios::binary)
  {
    this->file.seekg(std::streamoff(offset));
  }

  std::size_t Read(void* buffer, std::size_t count) override
  {
    this->file.read(static_cast<char*>(buffer), std::streamsize(count));
    if (this->file.bad())
    {
      FailToRead(this->path, "a file that can be read to its end", "a read error");
    }
    this->fileBytes += std::uint64_t(this->file.gcount());
    return std::size_t(this->file.gcount());
  }

  std::uint64_t FileBytes() override { return this->fileBytes; }

private:
  std::string path;
  std::ifstream file;
  std::uint64_t fileBytes = 0;
};

/// Gzip or zlib. libarchive does not compare the checksums of gzip, zlib does.
class InflateStream : public ByteStream
{
public:
  InflateStream(const std::string& path, std::uint64_t offset)
    : path(path)
    , file(path, offset)
    , input(1 << 16)
  {
    // 15 is the largest window; adding 32 makes zlib detect gzip or zlib from the header.
    if (inflateInit2(&this->state, 15 + 32) != Z_OK)
    {
      throw std::bad_alloc();
    }
  }
  ~InflateStream() override { inflateEnd(&this->state); }

  std::size_t Read(void* buffer, std::size_t count) override
  {
    std::size_t done = 0;
    while (done < count && !this->ended)
    {
      const std::size_t wanted =
        std::min<std::size_t>(count - done, std::numeric_limits<uInt>::max());
      this->state.next_out = static_cast<Bytef*>(buffer) + done;
      this->state.avail_out = uInt(wanted);
      this->Inflate();
      done += wanted - this->state.avail_out;
    }
    return done;
  }

  std::uint64_t FileBytes() override { return this->file.FileBytes(); }

private:
  /// Calls zlib's inflate once, with input available.
  void Inflate()
  {
    if (this->state.avail_in == 0 && !this->FillInput())
    {
      FailToRead(this->path, "a complete compressed stream",
        "its end after " + std::to_string(this->state.total_out) + " decompressed bytes");
    }
    const int result = inflate(&this->state, Z_NO_FLUSH);
    if (result == Z_STREAM_END)
    {
      this->StartNextMember();
    }
    else if (result != Z_OK && result != Z_BUF_ERROR)
    {
      FailToRead(this->path, "a compressed stream (gzip or zlib)",
        std::string("the error \"") + (this->state.msg ? this->state.msg : "corrupt") + '"');
    }
  }

  bool FillInput()
  {
    this->state.avail_in = uInt(this->file.Read(this->input.data(), this->input.size()));
    this->state.next_in = this->input.data();
    return this->state.avail_in > 0;
  }

  /// Continues with the next member of a gzip file; ignores anything else after the end.
  void StartNextMember()
  {
    const bool more = this->state.avail_in > 0 || this->FillInput();
    this->ended = !more || this->state.next_in[0] != 0x1f || inflateReset(&this->state) != Z_OK;
  }

  std::string path;
  FileStream file;
  std::vector<Bytef> input;
  z_stream state = {};
  bool ended = false;
};

class HexadecimalStream : public ByteStream
{
public:
  HexadecimalStream(const std::string& path, std::uint64_t offset)
    : path(path)
    , file(path, offset)
  {
  }

  std::size_t Read(void* buffer, std::size_t count) override
  {
    auto* bytes = static_cast<unsigned char*>(buffer);
    std::size_t done = 0;
    for (; done < count; ++done)
    {
      const int high = this->NextDigit();
      const int low = this->NextDigit();
      if (low < 0)
      {
        break;
      }
      bytes[done] = static_cast<unsigned char>(16 * high + low);
    }
    return done;
  }

  std::uint64_t FileBytes() override { return this->file.FileBytes(); }

private:
  /// The value of the next digit; -1 at the end.
  int NextDigit()
  {
    for (char character; this->file.Read(&character, 1) == 1;)
    {
      if (std::isxdigit(static_cast<unsigned char>(character)))
      {
        return character <= '9' ? character - '0' : std::tolower(character) - 'a' + 10;
      }
      if (!std::isspace(static_cast<unsigned char>(character)))
      {
        FailToRead(
          this->path, "hexadecimal digits", "the character " + Quoted(std::string(1, character)));
      }
    }
    return -1;
  }

  std::string path;
  FileStream file;
};

bool Begins(const char (&head)[10], const std::string& mark)
{
  return mark.compare(0, mark.size(), head, mark.size()) == 0;
}

}

std::uint64_t ByteStream::Skip(std::uint64_t count)
{
  char passed[4096];
  std::uint64_t done = 0;
  while (done < count)
  {
    const std::size_t got =
      this->Read(passed, std::size_t(std::min<std::uint64_t>(sizeof(passed), count - done)));
    if (got == 0)
    {
      break;
    }
    done += got;
  }
  return done;
}

Compression CompressionOf(const std::string& path)
{
  using namespace std::string_literals;
  char head[10] = {};
  FileStream(path, 0).Read(head, sizeof(head));
  if (Begins(head, "\x1f\x8b"))
  {
    return Compression::Deflate;
  }
  // The first block of bzip2 has a mark too, without which a text might begin like this.
  const bool isBzip2 = Begins(head, "BZh") && std::string(head + 4, 6) == "1AY&SY";
  const bool isXz = Begins(head,
    "\xfd"
    "7zXZ\0"s);
  const bool isZstandard = Begins(head, "\x28\xb5\x2f\xfd");
  return isBzip2 || isXz || isZstandard ? Compression::Other : Compression::None;
}

std::unique_ptr<ByteStream> OpenStream(
  const std::string& path, Compression compression, std::uint64_t offset)
{
  switch (compression)
  {
    case Compression::Deflate:
      return std::make_unique<InflateStream>(path, offset);
    case Compression::Other:
      return OpenArchiveStream(path, offset);
    case Compression::Hexadecimal:
      return std::make_unique<HexadecimalStream>(path, offset);
    case Compression::None:
      break;
  }
  return std::make_unique<FileStream>(path, offset);
}

double LargestRatio(Compression compression)
{
  switch (compression)
  {
    case Compression::Deflate:
      return LargestDeflateRatio;
    case Compression::Other:
      // bzip2 packs a block of up to 46 MB of equal bytes into about 40 bytes.
      return 1.2e6;
    case Compression::Hexadecimal:
      return 0.5;
    case Compression::None:
      break;
  }
  return 1.0;
}

std::unique_ptr<ByteStream> KeptStream::TakeAt(const std::string& wantedPath,
  Compression compression, std::uint64_t wantedOffset, std::uint64_t wantedPosition)
{
  const bool isBefore = this->stream && this->path == wantedPath && this->offset == wantedOffset &&
    this->position <= wantedPosition;
  auto taken =
    isBefore ? std::move(this->stream) : OpenStream(wantedPath, compression, wantedOffset);
  taken->Skip(wantedPosition - (isBefore ? this->position : 0));
  return taken;
}

void KeptStream::Keep(const std::string& keptPath, std::uint64_t keptOffset,
  std::uint64_t keptPosition, std::unique_ptr<ByteStream> kept)
{
  this->path = keptPath;
  this->offset = keptOffset;
  this->position = keptPosition;
  this->stream = std::move(kept);
}

}
