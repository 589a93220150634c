#include "Scene/VolumeWriters/VolumeWriters.h"

#include "Scene/OutputFile.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <stdexcept>

namespace varimarch
{

namespace
{

const std::vector<VolumeWriter> writers = {
  { "NIfTI", { ".nii", ".nii.gz" }, WriteNiftiFile, "" },
  { "NRRD", { ".nrrd" }, WriteNrrdFile, "" },
  { "MetaImage", { ".mha" }, WriteMetaImageFile, "" },
  { "VTI", { ".vti" }, WriteVtiFile, "" },
  { "TIFF", { ".tif", ".tiff" }, WriteTiffFile,
    "TIFF holds no position and no directions, so the file has only the spacing of the voxels." },
};

std::string LowerName(const std::string& path)
{
  std::string name = std::filesystem::path(path).filename().string();
  std::transform(name.begin(), name.end(), name.begin(),
    [](unsigned char letter) { return char(std::tolower(letter)); });
  return name;
}

bool EndsWith(const std::string& text, const std::string& end)
{
  return text.size() > end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

}

const std::vector<VolumeWriter>& VolumeWriters()
{
  return writers;
}

const VolumeWriter* WriterFor(const std::string& path)
{
  const std::string name = LowerName(path);
  const auto writer = std::find_if(writers.begin(), writers.end(),
    [&](const VolumeWriter& row)
    {
      return std::any_of(row.extensions.begin(), row.extensions.end(),
        [&](const std::string& extension) { return EndsWith(name, extension); });
    });
  return writer == writers.end() ? nullptr : &*writer;
}

std::vector<std::string> WriteVolume(const LoadedVolume& volume, const std::string& path)
{
  const VolumeWriter* const writer = WriterFor(path);
  if (!writer)
  {
    throw std::runtime_error(path + ": no format that can be written has this extension");
  }
  const bool isCompressed = EndsWith(LowerName(path), ".gz");
  WriteFileWhole(
    path, [&](const std::string& part) { return writer->write(volume, part, isCompressed); });
  return *writer->loss ? std::vector<std::string>{ writer->loss } : std::vector<std::string>();
}

}
