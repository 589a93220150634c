#include "Readers/ByteStream.h"

#include "Readers/FileError.h"

#include <zlib.h>

#include <algorithm>
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
    return std::size_t(this->file.gcount());
  }

private:
  std::string path;
  std::ifstream file;
};

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
  unsigned char head[2] = {};
  FileStream(path, 0).Read(head, 2);
  return head[0] == 0x1f && head[1] == 0x8b ? Compression::Deflate : Compression::None;
}

std::unique_ptr<ByteStream> OpenStream(
  const std::string& path, Compression compression, std::uint64_t offset)
{
  if (compression == Compression::Deflate)
  {
    return std::make_unique<InflateStream>(path, offset);
  }
  return std::make_unique<FileStream>(path, offset);
}

}
