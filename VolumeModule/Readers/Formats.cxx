#include "Readers/Formats.h"

#include "Readers/FileError.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>

namespace varimarch
{
namespace
{

bool IsGzip(const std::string& head)
{
  return head.compare(0, 2, "\x1f\x8b") == 0;
}

bool IsTar(const std::string& head)
{
  return head.size() > 262 && head.compare(257, 5, "ustar") == 0;
}

bool IsNifti(const std::string& head)
{
  const bool is1 =
    head.size() >= 348 && (head.compare(344, 3, "n+1") == 0 || head.compare(344, 3, "ni1") == 0);
  const bool is2 = head.compare(4, 3, "n+2") == 0 || head.compare(4, 3, "ni2") == 0;
  return is1 || is2;
}

const std::vector<VolumeFormat> formats = {
  { "NIfTI", "NIfTI images", { ".nii", ".nii.gz", ".hdr", ".img", ".hdr.gz", ".img.gz" },
    [](const std::string& head) { return IsGzip(head) || IsNifti(head); }, ReadNifti },
  { "VTI", "VTK images", { ".vti" },
    [](const std::string& head) { return head.find("VTKFile") != std::string::npos; }, ReadVti },
  { "InVesalius", "InVesalius projects", { ".inv3" },
    [](const std::string& head) { return IsGzip(head) || IsTar(head); }, ReadInv3 },
};

std::string LowerCase(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char character) { return char(std::tolower(character)); });
  return text;
}

bool EndsWith(const std::string& text, const std::string& end)
{
  return text.size() > end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

std::string FirstBytes(const std::string& path)
{
  std::string head(512, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(head.data(), std::streamsize(head.size()));
  head.resize(std::size_t(file.gcount()));
  return head;
}

const VolumeFormat* FormatOfName(const std::string& path)
{
  const std::string name = LowerCase(std::filesystem::path(path).filename());
  for (const VolumeFormat& format : formats)
  {
    for (const std::string& extension : format.extensions)
    {
      if (EndsWith(name, extension))
      {
        return &format;
      }
    }
  }
  return nullptr;
}

const VolumeFormat* FormatOfContent(const std::string& head)
{
  // Gzip says nothing about what is inside.
  if (IsGzip(head))
  {
    return nullptr;
  }
  const auto format = std::find_if(formats.begin(), formats.end(),
    [&](const VolumeFormat& row) { return row.recognises && row.recognises(head); });
  return format == formats.end() ? nullptr : &*format;
}

}

const std::vector<VolumeFormat>& VolumeFormats()
{
  return formats;
}

const VolumeFormat* FormatOfFile(const std::string& path, const ReadOptions&)
{
  if (const VolumeFormat* format = FormatOfName(path))
  {
    return format;
  }
  return FormatOfContent(FirstBytes(path));
}

bool LooksReadable(const std::string& path)
{
  const VolumeFormat* format = FormatOfFile(path, ReadOptions());
  if (!format || !std::ifstream(path))
  {
    return false;
  }
  return !format->recognises || format->recognises(FirstBytes(path));
}

Volume ReadVolume(const std::string& path, const ReadOptions& options, ReadProgress& progress)
{
  if (ReadableFileSize(path) == 0)
  {
    FailToRead(path, "a volume", "an empty file");
  }
  const VolumeFormat* format = FormatOfFile(path, options);
  if (!format)
  {
    FailToRead(path, "a volume of a known format",
      "bytes that begin with " + Quoted(FirstBytes(path).substr(0, 8)));
  }
  progress.Report(0.0);
  Volume volume = format->read(path, options, progress);
  progress.Report(1.0);
  return volume;
}

}
