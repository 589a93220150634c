// Packed volumes: archives, compressed files, and folders that hold a volume in files of any
// format. What is packed is unpacked into a private folder, and read from there.
#include "Readers/Packed/Unpacked.h"

#include "Readers/FileError.h"
#include "Readers/Formats.h"
#include "Readers/Packed/ByteStream.h"
#include "Readers/Packed/KeptInput.h"
#include "Readers/Packed/Unpacking.h"
#include "Readers/Parsing/FileContent.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <stdexcept>

namespace varimarch
{

Unpacked::Unpacked(
  const std::string& path, std::vector<std::string>& warnings, ReadProgress& progress)
  : original(path)
{
  const UnpackedContent content =
    Unpack({ path, this->folder.Path().string(), this->folder.FreeBytes() }, progress);
  this->copies = content.path;
  warnings.insert(warnings.end(), content.warnings.begin(), content.warnings.end());
}

std::string Unpacked::WithOriginalPaths(std::string message) const
{
  for (std::size_t place = message.find(this->copies); place != std::string::npos;
       place = message.find(this->copies, place + this->original.size()))
  {
    message.replace(place, this->copies.size(), this->original);
  }
  return message;
}

namespace
{

/// Reads plain copies, with messages about the packed files.
Volume ReadCopies(const Unpacked& copies, const ReadOptions& options, ReadProgress& progress)
{
  try
  {
    ReadOptions ofCopies = options;
    ofCopies.areCopies = true;
    Volume volume = ReadUnrectified(copies.Path(), ofCopies, progress);
    for (std::string& warning : volume.warnings)
    {
      warning = copies.WithOriginalPaths(warning);
    }
    return volume;
  }
  catch (const std::runtime_error& error)
  {
    throw std::runtime_error(copies.WithOriginalPaths(error.what()));
  }
}

/// True for a file in a folder that is a volume; archives in folders are not opened.
bool IsVolume(const std::string& file)
{
  const VolumeFormat* format = FormatOfMember(file);
  return format && format->read != ReadPacked;
}

bool IsDicomFile(const std::string& file)
{
  const VolumeFormat* format = FormatOfMember(file);
  return format && format->read == ReadDicom;
}

std::vector<std::string> VolumesBelow(const std::string& folder)
{
  std::vector<std::string> files = FilesBelow(folder);
  files.erase(std::remove_if(files.begin(), files.end(), std::not_fn(IsVolume)), files.end());
  return files;
}

}

bool HoldsDicom(const std::string& folder)
{
  const std::vector<std::string> files = FilesBelow(folder);
  return std::any_of(files.begin(), files.end(),
    [](const std::string& file)
    { return IsDicomFile(file) && CompressionOf(file) == Compression::None; });
}

bool HoldsInv3(const std::string& folder)
{
  const std::vector<std::string> files = FilesBelow(folder);
  return std::any_of(files.begin(), files.end(),
    [](const std::string& file)
    { return std::filesystem::path(file).filename() == InVesaliusFile; });
}

bool HoldsPictures(const std::string& folder)
{
  bool hasPictures = false;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
  {
    const VolumeFormat* const format =
      entry.is_regular_file() ? FormatOfMember(entry.path()) : nullptr;
    const bool isPicture = format && (format->read == ReadTiff || format->read == ReadImageStack);
    if (format && !isPicture)
    {
      return false;
    }
    hasPictures = hasPictures || isPicture;
  }
  return hasPictures;
}

bool HoldsVolumes(const std::string& folder)
{
  const std::vector<std::string> files = FilesBelow(folder);
  return std::any_of(files.begin(), files.end(), IsVolume);
}

std::unique_ptr<Unpacked> UnpackedIfPacked(
  const std::string& path, std::vector<std::string>& warnings, ReadProgress& progress)
{
  const VolumeFormat* format = FormatOfFile(path, ReadOptions());
  // Plain DICOM files would have made a folder DICOM, so these are compressed ones.
  const bool isPacked = format && format->read == ReadPacked &&
    (!std::filesystem::is_directory(path) || IsDicomFile(VolumesBelow(path).front()));
  return isPacked ? std::make_unique<Unpacked>(path, warnings, progress) : nullptr;
}

Volume ReadPacked(const std::string& path, const ReadOptions& options, ReadProgress& progress)
{
  ReadProgress unpacking = progress.Part(0.0, 0.5);
  ReadProgress reading = progress.Part(0.5, 1.0);
  KeptInput once;
  KeptInput& kept = options.kept ? *options.kept : once;
  if (kept.copies.count(path) == 0)
  {
    KeptCopies made;
    made.copies = UnpackedIfPacked(path, made.warnings, unpacking);
    kept.copies[path] = std::move(made);
  }
  const auto& copies = kept.copies[path].copies;
  std::vector<std::string> warnings = kept.copies[path].warnings;
  const std::vector<std::string> files = copies ? std::vector<std::string>() : VolumesBelow(path);
  if (!copies && files.empty())
  {
    // Only its name was that of an archive.
    FailToRead(path, "an archive or a compressed file", DescribedContent(FirstBytes(path)));
  }
  if (files.size() > 1)
  {
    warnings.push_back("The folder holds " + std::to_string(files.size()) + " volumes; only " +
      std::filesystem::path(files.front()).filename().string() + " was read.");
  }
  Volume volume = copies ? ReadCopies(*copies, options, reading)
                         : ReadUnrectified(files.front(), options, reading);
  volume.warnings.insert(volume.warnings.begin(), warnings.begin(), warnings.end());
  return volume;
}

}
