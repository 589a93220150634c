// libarchive opens archives, zlib and libarchive decompress.
#include "Readers/Packed/Unpacking.h"

#include "Readers/FileError.h"
#include "Readers/Packed/ByteStream.h"
#include "Readers/Parsing/FileContent.h"
#include "Readers/VoxelLayout.h"

#include <archive.h>
#include <archive_entry.h>

#include <algorithm>
#include <cerrno>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <new>

namespace varimarch
{
namespace
{

/// An archive or a compressed stream that libarchive reads. The caller enables the formats and
/// filters that it expects, then opens it.
class ArchiveInput
{
public:
  /// @param path  path for error messages
  explicit ArchiveInput(const std::string& path);
  ~ArchiveInput();
  ArchiveInput(const ArchiveInput&) = delete;
  void operator=(const ArchiveInput&) = delete;

  archive* Handle() { return this->handle; }

  /// Opens the file itself, in which libarchive may jump; ZIP has its directory at the end.
  void OpenFile();
  /// Opens a stream of the file's bytes.
  void OpenBytes(std::unique_ptr<ByteStream> bytes);

  /// Number of the file's bytes that have been read so far.
  std::uint64_t FileBytes();

  /// Passes on the result of a call of libarchive.
  /// @throws std::runtime_error if the call has failed
  long Checked(long result);

private:
  static long ReadChunk(archive*, void* self, const void** chunk);

  std::string path;
  archive* handle;
  std::unique_ptr<ByteStream> bytes;
  std::vector<char> chunk;
  /// An error of the stream, which must not be thrown through libarchive.
  std::exception_ptr error;
};

constexpr std::size_t chunkBytes = 1 << 16;

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

namespace fs = std::filesystem;

/// Fails for a ZIP archive without the record at its end, before a comment of at most 64 kB.
/// libarchive would return the entries before the cut without an error.
void CheckZipIsWhole(const std::string& path)
{
  const std::uint64_t fileBytes = ReadableFileSize(path);
  std::string tail(std::size_t(std::min<std::uint64_t>(fileBytes, 66000)), '\0');
  OpenStream(path, Compression::None, fileBytes - tail.size())->Read(tail.data(), tail.size());
  if (IsZip(FirstBytes(path)) && tail.find("PK\5\6") == std::string::npos)
  {
    FailToRead(path, "a complete ZIP archive", "one without its end");
  }
}

/// Path of an entry within its archive; empty if it is no file, or leads out of the archive.
std::string InnerPath(archive_entry* entry)
{
  const bool isFile = archive_entry_filetype(entry) == AE_IFREG && !archive_entry_hardlink(entry);
  const char* utf8 = archive_entry_pathname_utf8(entry);
  const char* name = utf8 ? utf8 : archive_entry_pathname(entry);
  if (!isFile || !name)
  {
    return "";
  }
  std::string text = name;
  std::replace(text.begin(), text.end(), '\\', '/');
  const fs::path path = text;
  const bool leadsOut =
    path.is_absolute() || std::find(path.begin(), path.end(), "..") != path.end();
  return leadsOut ? "" : text;
}

/// The file's name without the extension of its compression.
std::string PlainName(const fs::path& path)
{
  const std::string extension = path.extension().string();
  const bool isCompression = extension == ".gz" || extension == ".bz2" || extension == ".xz" ||
    extension == ".zst" || extension == ".GZ";
  return (isCompression ? path.stem() : path.filename()).string();
}

/// Unpacks into a folder. Files in it are all that is written.
class Unpacker
{
public:
  Unpacker(const UnpackingOrder& order)
    : original(order.path)
    , folder(order.folder)
    , spaceBytes(order.spaceBytes)
  {
  }

  UnpackedContent Unpack(ReadProgress& progress);

private:
  /// Fills a buffer; returns less than `count` bytes only at the end.
  using Source = std::function<std::size_t(void* buffer, std::size_t count)>;

  void UnpackArchive(ReadProgress& progress);
  void UnpackEntry(ArchiveInput& input, archive_entry* entry, const std::string& to,
    const std::function<void()>& report);
  void UnpackFile(const std::string& from, const std::string& to, ReadProgress& progress);
  void UnpackFolder(ReadProgress& progress);
  void Write(const std::string& to, const Source& source, const std::function<void()>& report);
  void CheckSpace(double byteCount) const;

  std::string original;
  std::string folder;
  double spaceBytes; ///< space for copies
  double usedBytes = 0.0;
  UnpackedContent content;
};

UnpackedContent Unpacker::Unpack(ReadProgress& progress)
{
  const fs::path place = this->folder;
  this->content.path = (place / "content").string();
  if (fs::is_directory(this->original))
  {
    this->UnpackFolder(progress);
  }
  else if (IsArchive(FirstBytes(this->original)))
  {
    this->UnpackArchive(progress);
  }
  else
  {
    this->content.path = (place / PlainName(this->original)).string();
    this->UnpackFile(this->original, this->content.path, progress);
  }
  return this->content;
}

void Unpacker::UnpackArchive(ReadProgress& progress)
{
  ArchiveInput input(this->original);
  archive_read_support_format_tar(input.Handle());
  archive_read_support_format_zip(input.Handle());
  const Compression compression = CompressionOf(this->original);
  if (compression == Compression::None)
  {
    CheckZipIsWhole(this->original);
    input.OpenFile();
  }
  else
  {
    input.OpenBytes(OpenStream(this->original, compression));
  }
  fs::create_directory(this->content.path);
  const double packedBytes = double(ReadableFileSize(this->original));
  const auto report = [&]
  { progress.Report(std::min(1.0, double(input.FileBytes()) / packedBytes)); };
  int leftOut = 0;
  archive_entry* entry = nullptr;
  while (input.Checked(archive_read_next_header(input.Handle(), &entry)) != ARCHIVE_EOF)
  {
    const std::string inner = InnerPath(entry);
    leftOut += inner.empty() && archive_entry_filetype(entry) != AE_IFDIR ? 1 : 0;
    if (!inner.empty())
    {
      this->UnpackEntry(input, entry, (fs::path(this->content.path) / inner).string(), report);
    }
  }
  if (leftOut > 0)
  {
    this->content.warnings.push_back(std::to_string(leftOut) + " of the archive's entries " +
      (leftOut == 1 ? "was" : "were") + " left out: links, or paths that lead out of it.");
  }
}

void Unpacker::UnpackEntry(ArchiveInput& input, archive_entry* entry, const std::string& to,
  const std::function<void()>& report)
{
  if (archive_entry_is_encrypted(entry))
  {
    FailToRead(this->original, "an archive without a password", "an encrypted one");
  }
  // Streamed archives state no size, which counts as 0.
  this->CheckSpace(double(archive_entry_size(entry)));
  this->Write(
    to,
    [&](void* buffer, std::size_t count)
    { return std::size_t(input.Checked(archive_read_data(input.Handle(), buffer, count))); },
    report);
}

void Unpacker::UnpackFile(const std::string& from, const std::string& to, ReadProgress& progress)
{
  const double packedBytes = double(ReadableFileSize(from));
  const auto stream = OpenStream(from, CompressionOf(from));
  this->Write(
    to, [&](void* buffer, std::size_t count) { return stream->Read(buffer, count); },
    [&] { progress.Report(std::min(1.0, double(stream->FileBytes()) / packedBytes)); });
}

void Unpacker::UnpackFolder(ReadProgress& progress)
{
  const std::vector<std::string> files = FilesBelow(this->original);
  for (std::size_t i = 0; i < files.size(); ++i)
  {
    ReadProgress part =
      progress.Part(double(i) / double(files.size()), double(i + 1) / double(files.size()));
    const fs::path inner = fs::relative(files[i], this->original);
    const fs::path to = fs::path(this->content.path) / inner.parent_path() / PlainName(inner);
    this->UnpackFile(files[i], to.string(), part);
  }
}

void Unpacker::Write(
  const std::string& to, const Source& source, const std::function<void()>& report)
{
  std::error_code ignored;
  fs::create_directories(fs::path(to).parent_path(), ignored);
  std::ofstream file(to, std::ios::binary);
  std::vector<char> buffer(1 << 20);
  // A file takes at least a block, however short it is.
  this->usedBytes += 4096.0;
  for (std::size_t got = buffer.size(); got == buffer.size();)
  {
    report();
    got = source(buffer.data(), buffer.size());
    this->CheckSpace(double(got));
    this->usedBytes += double(got);
    file.write(buffer.data(), std::streamsize(got));
  }
  if (!file.flush())
  {
    FailToRead(this->original, "content that can be copied to " + Quoted(this->folder, 80),
      "the file " + Quoted(fs::path(to).filename().string()) + ", which cannot be written");
  }
}

void Unpacker::CheckSpace(double byteCount) const
{
  if (this->usedBytes + byteCount > this->spaceBytes)
  {
    FailToRead(this->original,
      "content that fits in the free memory of " + ByteText(this->spaceBytes), "more than that");
  }
}

}

UnpackedContent Unpack(const UnpackingOrder& order, ReadProgress& progress)
{
  return Unpacker(order).Unpack(progress);
}

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
