#include "Scene/VolumeWriters/VolumeWriters.h"

#include "Scene/OutputFile.h"

#include <vtksys/SystemTools.hxx>

#include <algorithm>
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
  return vtksys::SystemTools::LowerCase(std::filesystem::path(path).filename().string());
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
        [&](const std::string& extension)
        { return vtksys::SystemTools::StringEndsWith(name, extension.c_str()); });
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
  const bool isCompressed = vtksys::SystemTools::StringEndsWith(LowerName(path), ".gz");
  WriteFileWhole(
    path, [&](const std::string& part) { return writer->write(volume, part, isCompressed); });
  return *writer->loss ? std::vector<std::string>{ writer->loss } : std::vector<std::string>();
}

}
