#include "Readers/FileContent.h"

#include "Readers/ByteStream.h"
#include "Readers/FileError.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <set>

namespace varimarch
{
namespace
{

struct Content
{
  const char* name;
  Signature signature;
};

/// Files that people try to open although they hold no volume, or none that is read.
const std::vector<Content>& KnownContents()
{
  using namespace std::string_literals;
  static const std::vector<Content> contents = {
    { "a TIFF image", TextAt(0, { "II*\0"s, "MM\0*"s, "II+\0"s, "MM\0+"s }) },
    { "a PNG image", TextAt(0, { "\x89PNG" }) },
    { "a JPEG image", TextAt(0, { "\xff\xd8\xff" }) },
    { "a GIF image", TextAt(0, { "GIF87a", "GIF89a" }) },
    { "a NumPy array", TextAt(0, { "\x93NUMPY" }) },
    { "an HDF5 file, perhaps MINC 2", TextAt(0, { "\x89HDF\r\n\x1a\n" }) },
    { "a NetCDF file, perhaps MINC 1", TextAt(0, { "CDF\1", "CDF\2" }) },
    { "a FreeSurfer volume (MGH)", TextAt(0, { "\0\0\0\1\0\0"s }) },
    { "a VTK file of another kind than image data", TextAt(0, { "# vtk DataFile" }) },
    { "a PDF document", TextAt(0, { "%PDF" }) },
    { "a program",
      TextAt(0,
        { "\x7f"
          "ELF" }) },
    { "a web page", TextAt(0, { "<html", "<HTML", "<!DOCTYPE html", "<!doctype html" }) },
    { "a ZIP archive", TextAt(0, { "PK\3\4", "PK\5\6" }) },
    { "a RAR archive", TextAt(0, { "Rar!" }) },
    { "a 7-Zip archive", TextAt(0, { "7z\xbc\xaf\x27\x1c" }) },
  };
  return contents;
}

bool IsText(const std::string& head)
{
  return std::none_of(head.begin(), head.end(),
    [](unsigned char byte) { return byte < ' ' && byte != '\n' && byte != '\r' && byte != '\t'; });
}

std::string Hexadecimal(const std::string& bytes)
{
  std::string text;
  for (const unsigned char byte : bytes)
  {
    char digits[4];
    std::snprintf(digits, sizeof(digits), "%s%02x", text.empty() ? "" : " ", byte);
    text += digits;
  }
  return text;
}

/// True for a folder that a symbolic link makes appear again.
bool IsRepeated(
  const std::filesystem::directory_entry& entry, std::set<std::filesystem::path>& visited)
{
  std::error_code ignored;
  return entry.is_directory(ignored) &&
    !visited.insert(std::filesystem::canonical(entry.path(), ignored)).second;
}

bool IsHidden(const std::filesystem::path& path)
{
  // macOS adds a folder __MACOSX with its own files to ZIP archives.
  return path.filename().string()[0] == '.' || path.filename() == "__MACOSX";
}

}

Signature TextAt(std::size_t offset, std::vector<std::string> texts)
{
  return [offset, texts = std::move(texts)](const std::string& head)
  {
    return std::any_of(texts.begin(), texts.end(),
      [&](const std::string& text)
      { return head.size() > offset && head.compare(offset, text.size(), text) == 0; });
  };
}

std::string FirstBytes(const std::string& path)
{
  std::string head(4096, '\0');
  head.resize(OpenStream(path, CompressionOf(path))->Read(head.data(), head.size()));
  return head;
}

std::string KnownContent(const std::string& head)
{
  const auto& contents = KnownContents();
  const auto content = std::find_if(contents.begin(), contents.end(),
    [&](const Content& candidate) { return candidate.signature(head); });
  return content == contents.end() ? "" : content->name;
}

std::string DescribedContent(const std::string& head)
{
  const std::string known = KnownContent(head);
  if (!known.empty())
  {
    return known;
  }
  return IsText(head) ? "text that begins with " + Quoted(head)
                      : "binary data that begins with the bytes " + Hexadecimal(head.substr(0, 8));
}

std::vector<std::string> FilesBelow(const std::string& folder)
{
  namespace fs = std::filesystem;
  std::vector<std::string> files;
  std::error_code error;
  std::error_code ignored;
  std::set<fs::path> visited = { fs::canonical(folder, ignored) };
  fs::recursive_directory_iterator entry(folder,
    fs::directory_options::skip_permission_denied | fs::directory_options::follow_directory_symlink,
    error);
  for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error))
  {
    if (IsHidden(entry->path()) || IsRepeated(*entry, visited))
    {
      entry.disable_recursion_pending();
    }
    else if (entry->is_regular_file(ignored))
    {
      files.push_back(entry->path().string());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::string DescribedFolder(const std::string& folder)
{
  const std::vector<std::string> files = FilesBelow(folder);
  if (files.empty())
  {
    return "a folder without files";
  }
  const std::string first = Quoted(std::filesystem::path(files.front()).filename().string());
  const std::string content = DescribedContent(FirstBytes(files.front()));
  return files.size() == 1
    ? "only the file " + first + ", which is " + content
    : std::to_string(files.size()) + " files, the first of which, " + first + ", is " + content;
}

}
