#include "Readers/ArchiveInput.h"

#include "Readers/FileError.h"

#include <archive.h>

#include <cerrno>
#include <new>

namespace varimarch
{
namespace
{

constexpr std::size_t chunkBytes = 1 << 16;

}

ArchiveInput::ArchiveInput(const std::string& path)
  : path(path)
  , handle(archive_read_new())
{
  if (!this->handle)
  {
    throw std::bad_alloc();
  }
}

ArchiveInput::~ArchiveInput()
{
  archive_read_free(this->handle);
}

void ArchiveInput::OpenFile()
{
  this->Checked(archive_read_open_filename(this->handle, this->path.c_str(), chunkBytes));
}

void ArchiveInput::OpenBytes(std::unique_ptr<ByteStream> opened)
{
  this->bytes = std::move(opened);
  this->chunk.resize(chunkBytes);
  this->Checked(archive_read_open(this->handle, this, nullptr, &ArchiveInput::ReadChunk, nullptr));
}

std::uint64_t ArchiveInput::FileBytes()
{
  return this->bytes ? this->bytes->FileBytes()
                     : std::uint64_t(archive_filter_bytes(this->handle, -1));
}

long ArchiveInput::Checked(long result)
{
  if (this->error)
  {
    std::rethrow_exception(this->error);
  }
  if (result < ARCHIVE_WARN)
  {
    const char* text = archive_error_string(this->handle);
    FailToRead(this->path, "a complete archive or compressed file",
      "the fault " + Quoted(text ? text : "unknown", 100));
  }
  return result;
}

long ArchiveInput::ReadChunk(archive* handle, void* self, const void** chunk)
{
  auto* input = static_cast<ArchiveInput*>(self);
  *chunk = input->chunk.data();
  try
  {
    return long(input->bytes->Read(input->chunk.data(), input->chunk.size()));
  }
  catch (const std::exception&)
  {
    input->error = std::current_exception();
    archive_set_error(handle, EIO, "a read error");
    return -1;
  }
}

}
