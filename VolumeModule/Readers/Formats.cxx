#include "Readers/Formats.h"

#include "Readers/FileError.h"
#include "Readers/HeaderText.h"
#include "Readers/Rectify.h"

#include <algorithm>
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

bool IsDicom(const std::string& head)
{
  return head.size() >= 132 && head.compare(128, 4, "DICM") == 0;
}

bool IsMetaImage(const std::string& head)
{
  return head.find("NDims") != std::string::npos || head.find("ObjectType") != std::string::npos;
}

// The first row whose extension or first bytes match is used; raw voxels match nothing and come
// last.
const std::vector<VolumeFormat> formats = {
  { "NRRD", "NRRD images", { ".nrrd", ".nhdr" },
    [](const std::string& head) { return head.compare(0, 4, "NRRD") == 0; }, ReadNrrd },
  { "MetaImage", "MetaImages", { ".mha", ".mhd" }, IsMetaImage, ReadMetaImage },
  { "NIfTI", "NIfTI images", { ".nii", ".nii.gz", ".hdr", ".img", ".hdr.gz", ".img.gz" }, IsNifti,
    ReadNifti },
  { "VTI", "VTK images", { ".vti" },
    [](const std::string& head) { return head.find("<VTKFile") != std::string::npos; }, ReadVti },
  { "DICOM", "DICOM images", { ".dcm", ".dicom", ".ima" }, IsDicom, ReadDicom },
  { "InVesalius", "InVesalius projects", { ".inv3" }, IsTar, ReadInv3 },
  { "raw", "Raw voxels", { ".raw", ".raw.gz" }, nullptr, ReadRaw },
};

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
  for (const VolumeFormat& format : formats)
  {
    if (format.recognises && format.recognises(head))
    {
      return &format;
    }
  }
  return nullptr;
}

}

const std::vector<VolumeFormat>& VolumeFormats()
{
  return formats;
}

const VolumeFormat* FormatOfFile(const std::string& path, const ReadOptions& options)
{
  if (std::filesystem::is_directory(path))
  {
    return FormatOfName("folder.dcm");
  }
  const VolumeFormat* format = FormatOfName(path);
  if (!format)
  {
    format = FormatOfContent(FirstBytes(path));
  }
  const bool isDescribed = options.raw.dimensions[0] > 0;
  return !format && isDescribed ? &formats.back() : format;
}

bool LooksReadable(const std::string& path)
{
  if (std::filesystem::is_directory(path))
  {
    return true;
  }
  const std::string head = FirstBytes(path);
  const VolumeFormat* format = FormatOfFile(path, ReadOptions());
  if (head.empty() || !format)
  {
    return false;
  }
  // A gzip header does not show what is compressed.
  return !format->recognises || format->recognises(head) || IsGzip(head);
}

Volume ReadVolume(const std::string& path, const ReadOptions& options, ReadProgress& progress)
{
  if (!std::filesystem::is_directory(path) && ReadableFileSize(path) == 0)
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
  ReadProgress reading = progress.Part(0.0, options.rectify ? 0.8 : 1.0);
  ReadProgress rectifying = progress.Part(0.8, 1.0);
  Volume volume = format->read(path, options, reading);
  if (options.rectify)
  {
    volume = Rectified(path, volume, rectifying);
  }
  progress.Report(1.0);
  return volume;
}

}
