#include "Readers/Parsing/FileContent.h"

#include "Readers/FileError.h"
#include "Readers/Formats.h"
#include "Readers/Packed/ByteStream.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <numeric>
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

namespace
{

/// A 16-bit number of a little-endian file; 0 behind its end.
unsigned ShortAt(const std::string& head, std::size_t offset)
{
  const auto byteAt = [&](std::size_t place)
  { return place < head.size() ? unsigned(static_cast<unsigned char>(head[place])) : 0u; };
  return byteAt(offset) + 256 * byteAt(offset + 1);
}

bool IsPicture(const std::string& head)
{
  return IsPng(head) || IsJpeg(head) || IsBmp(head);
}

/// The mark of all tar formats, also those without the letters "ustar": a checksum in octal digits,
/// which counts its own field as blanks.
bool IsTar(const std::string& head)
{
  if (head.size() < 512)
  {
    return false;
  }
  const auto sum = [](unsigned before, unsigned char byte) { return before + byte; };
  const unsigned total = std::accumulate(head.begin(), head.begin() + 148, 0u, sum) + 8u * ' ' +
    std::accumulate(head.begin() + 156, head.begin() + 512, 0u, sum);
  return head[0] != '\0' &&
    std::strtoul(head.substr(148, 8).c_str(), nullptr, 8) == (unsigned long)(total);
}

}

bool IsDicom(const std::string& head)
{
  const unsigned group = ShortAt(head, 0);
  const bool hasGroup = head.size() > 8 && (group == 2 || group == 8);
  const bool isExplicit = hasGroup && std::isupper(static_cast<unsigned char>(head[4])) &&
    std::isupper(static_cast<unsigned char>(head[5]));
  const std::size_t next = 8 + ShortAt(head, 4);
  const bool isImplicit = hasGroup && ShortAt(head, 6) == 0 && ShortAt(head, 4) % 2 == 0 &&
    ShortAt(head, next) == group && ShortAt(head, next + 2) > ShortAt(head, 2);
  return TextAt(128, { "DICM" })(head) || isExplicit || isImplicit;
}

bool IsArchive(const std::string& head)
{
  return IsZip(head) || IsTar(head);
}

bool IsBmp(const std::string& head)
{
  // After the mark and the size of the file, four bytes are zero.
  return head.compare(0, 2, "BM") == 0 && head.size() >= 26 &&
    head.compare(6, 4, std::string(4, '\0')) == 0;
}

bool IsHdf5(const std::string& head)
{
  // A block of another program may stand before it, as in files of MATLAB.
  const std::string mark = "\x89HDF\r\n\x1a\n";
  const std::size_t places[] = { 0, 512, 1024, 2048 };
  return std::any_of(std::begin(places), std::end(places),
    [&](std::size_t place)
    { return place < head.size() && head.compare(place, mark.size(), mark) == 0; });
}

bool IsJpeg(const std::string& head)
{
  return head.compare(0, 3, "\xff\xd8\xff") == 0;
}

bool IsMinc(const std::string& head)
{
  return head.compare(0, 4, std::string("CDF\x01")) == 0 ||
    head.compare(0, 4, std::string("CDF\x02")) == 0 ||
    (IsHdf5(head) && head.find("minc-2.0") != std::string::npos);
}

bool IsPng(const std::string& head)
{
  return head.compare(0, 8, "\x89PNG\r\n\x1a\n") == 0;
}

bool IsStackSlice(const std::string& head)
{
  return IsPicture(head) || IsTiff(head);
}

bool IsTiff(const std::string& head)
{
  const std::string begin = head.substr(0, 4);
  return begin == std::string("II*\0", 4) || begin == std::string("MM\0*", 4) ||
    begin == std::string("II+\0", 4) || begin == std::string("MM\0+", 4);
}

bool IsZip(const std::string& head)
{
  return TextAt(0, { "PK\3\4", "PK\5\6", "PK00PK\3\4" })(head);
}

}
