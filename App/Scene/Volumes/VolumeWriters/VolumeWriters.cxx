#include "Scene/Volumes/VolumeWriters/VolumeWriters.h"

#include "Scene/Files/OutputFile.h"
#include "Scene/Volumes/VolumeWriters/WrittenImage.h"

#include <vtkErrorCode.h>
#include <vtkNew.h>
#include <vtkXMLImageDataWriter.h>
#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

namespace varimarch
{

namespace
{

std::string NoLoss(const LoadedVolume&)
{
  return "";
}

std::string LossOfSegments(const LoadedVolume& volume)
{
  return volume.segments.empty()
    ? ""
    : "The format holds no names and colours of segments, so the file has only their values; a "
      ".seg.nrrd holds them.";
}

std::string LossOfTiff(const LoadedVolume&)
{
  return "TIFF holds no position and no directions, so the file has only the spacing of the "
         "voxels; its columns run to the patient's left, its rows to the back and its slices to "
         "the head, as nearly as the axes allow.";
}

std::string LossOfZarrFolder(const LoadedVolume& volume)
{
  return LossOfZarr(ZarrInputOf(volume));
}

bool WriteZarrFolder(const LoadedVolume& volume, const std::string& path, bool)
{
  WriteZarr(ZarrInputOf(volume), path, {});
  return true;
}

bool MayReplaceZarr(const std::string& existing)
{
  const std::filesystem::path folder = existing;
  return std::filesystem::exists(folder / ".zgroup") || std::filesystem::exists(folder / ".zarray");
}

constexpr bool isFolder = true;

const std::vector<VolumeWriter> writers = {
  { "NIfTI", { ".nii", ".nii.gz" }, WriteNiftiFile, LossOfSegments },
  { "NRRD", { ".nrrd" }, WriteNrrdFile, NoLoss },
  { "MetaImage", { ".mha" }, WriteMetaImageFile, LossOfSegments },
  { "VTI", { ".vti" }, WriteVtiFile, LossOfSegments },
  { "TIFF", { ".tif", ".tiff" }, WriteTiffFile, LossOfTiff },
  { "OME-Zarr", { ".zarr" }, WriteZarrFolder, LossOfZarrFolder, isFolder },
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
  const auto write = [&](const std::string& part)
  { return writer->write(volume, part, isCompressed); };
  if (writer->isFolder)
  {
    WriteFolderWhole(path, MayReplaceZarr, write);
  }
  else
  {
    WriteFileWhole(path, write);
  }
  const std::string loss = writer->loss(volume);
  return loss.empty() ? std::vector<std::string>() : std::vector<std::string>{ loss };
}

std::vector<std::string> WriteChunkedVolume(
  const ZarrInput& input, const std::string& path, const LoadObserver& observer)
{
  WriteFolderWhole(
    path, MayReplaceZarr, [&](const std::string& part) { WriteZarr(input, part, observer); });
  std::vector<std::string> sentences;
  const std::string loss = LossOfZarr(input);
  if (!loss.empty())
  {
    sentences.push_back(loss);
  }
  if (input.lacksChunks && *input.lacksChunks)
  {
    sentences.push_back(
      "Chunks are missing in the file that was read; their voxels have the fill value.");
  }
  return sentences;
}

// VTK's XML image data, by VTK's own writer.

bool WriteVtiFile(const LoadedVolume& volume, const std::string& path, bool)
{
  const WrittenImage checked(path, volume.image);
  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetInputData(volume.image);
  writer->SetFileName(path.c_str());
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  // Arrays beyond 4 GB need headers of 64 bits.
  writer->SetHeaderTypeToUInt64();
  return writer->Write() == 1 && writer->GetErrorCode() == vtkErrorCode::NoError;
}

}
