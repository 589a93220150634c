// libarchive opens archives, zlib and libarchive decompress.
#include "Readers/Unpacking.h"
#include "Readers/ArchiveInput.h"
#include "Readers/FileContent.h"
#include "Readers/FileError.h"
#include "Readers/Signatures.h"
#include "Readers/VoxelLayout.h"

#include <archive.h>
#include <archive_entry.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>

namespace varimarch
{
namespace
{

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

}
