#ifndef Varimarch_Scene_VolumeWriters_h
#define Varimarch_Scene_VolumeWriters_h

#include "Scene/Volumes/VolumeLoading.h"
#include "Scene/Volumes/VolumeWriters/ZarrFolder.h"

#include <functional>
#include <string>
#include <vector>

namespace varimarch
{

/// A file format that volumes can be written in: a row of the table in VolumeWriters.cxx.
struct VolumeWriter
{
  const char* name;
  std::vector<std::string> extensions; ///< lower case, with the dot
  /// Writes a new file. Returns false if the system refuses to; errno then has its reason.
  /// @throws std::runtime_error with one sentence if the format cannot hold the volume
  bool (*write)(const LoadedVolume& volume, const std::string& path, bool isCompressed);
  /// A sentence about what the format does not hold of a volume, or empty.
  std::string (*loss)(const LoadedVolume& volume);
  bool isFolder = false; ///< true for a format that is a folder, which `write` fills
};

const std::vector<VolumeWriter>& VolumeWriters();

/// The writer for a file's extension; null if there is none.
const VolumeWriter* WriterFor(const std::string& path);

/// Writes a volume in the format of the path's extension. An existing file is replaced only when
/// the new one is complete.
/// @returns sentences about what the format does not hold
/// @throws std::runtime_error with one sentence if the format cannot hold the volume, or the file
///   cannot be written
std::vector<std::string> WriteVolume(const LoadedVolume& volume, const std::string& path);

/// Writes a folder of OME-Zarr as WriteVolume does, of a volume that may be larger than memory.
/// Only a folder of Zarr is replaced.
/// @param observer  receives the part that is done, [0, 1], and returns false to cancel
/// @returns as WriteVolume, with a sentence if the file that is read lacks chunks
std::vector<std::string> WriteChunkedVolume(
  const ZarrInput& input, const std::string& path, const LoadObserver& observer = {});

bool WriteNrrdFile(const LoadedVolume& volume, const std::string& path, bool isCompressed);
bool WriteMetaImageFile(const LoadedVolume& volume, const std::string& path, bool isCompressed);
bool WriteNiftiFile(const LoadedVolume& volume, const std::string& path, bool isCompressed);
bool WriteVtiFile(const LoadedVolume& volume, const std::string& path, bool isCompressed);
bool WriteTiffFile(const LoadedVolume& volume, const std::string& path, bool isCompressed);

}

#endif
