#include "Readers/ArchiveInput.h"
#include "Readers/ByteStream.h"
#include "Readers/FileError.h"

#include <archive.h>
#include <archive_entry.h>

#include <algorithm>

namespace varimarch
{
namespace
{

/// The compressions that libarchive detects.
class ArchiveStream : public ByteStream
{
public:
  ArchiveStream(const std::string& path, std::uint64_t offset)
    : input(path)
  {
    archive* handle = this->input.Handle();
    archive_read_support_format_raw(handle);
    archive_read_support_filter_bzip2(handle);
    archive_read_support_filter_xz(handle);
    archive_read_support_filter_zstd(handle);
    this->input.OpenBytes(OpenStream(path, Compression::None, offset));
    archive_entry* entry = nullptr;
    this->input.Checked(archive_read_next_header(handle, &entry));
    if (archive_filter_code(handle, 0) == ARCHIVE_FILTER_NONE)
    {
      FailToRead(path, "a stream that bzip2, xz or Zstandard has compressed", "another one");
    }
  }

  std::size_t Read(void* buffer, std::size_t count) override
  {
    std::size_t done = 0;
    long got = 1;
    while (done < count && got > 0)
    {
      got = this->input.Checked(
        archive_read_data(this->input.Handle(), static_cast<char*>(buffer) + done, count - done));
      done += std::size_t(std::max(0L, got));
    }
    return done;
  }

  std::uint64_t FileBytes() override { return this->input.FileBytes(); }

private:
  ArchiveInput input;
};

}

std::unique_ptr<ByteStream> OpenArchiveStream(const std::string& path, std::uint64_t offset)
{
  return std::make_unique<ArchiveStream>(path, offset);
}

}
