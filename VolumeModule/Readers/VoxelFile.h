#ifndef Varimarch_Readers_VoxelFile_h
#define Varimarch_Readers_VoxelFile_h

#include "Readers/ByteStream.h"
#include "Readers/VolumeFile.h"
#include "Readers/VoxelLayout.h"

#include <cstdint>
#include <string>
#include <vector>

namespace varimarch
{

enum class VoxelEncoding
{
  Binary,
  Text ///< decimal numbers between blanks or commas
};

/// Where the voxels are, and how they are written.
struct VoxelFile
{
  /// Stands for as many bytes of a file as there are before voxels that end with the file.
  static constexpr std::int64_t FromEnd = -1;

  std::vector<std::string> paths; ///< each holds an equal part, in order
  std::int64_t volumeCount = 1;   ///< in all of them; only the first volume is read
  VoxelEncoding encoding = VoxelEncoding::Binary;
  Compression compression = Compression::None;
  bool bigEndian = false;
  bool planar = false;         ///< all values of component 0, then of 1, and so on
  std::int64_t fileOffset = 0; ///< bytes to skip in each file, or FromEnd (uncompressed only)
  std::int64_t dataOffset = 0; ///< bytes to skip after decompression
};

/// Reads the voxels into a new image at the origin with spacing 1. Sizes are checked, against
/// memory and against the files, before memory is taken.
/// @throws std::runtime_error when the files hold less than the layout promises, or other things
/// @throws ReadCancelled
vtkSmartPointer<vtkImageData> ReadVoxels(
  const VoxelFile& file, const VoxelLayout& layout, ReadProgress& progress);

/// Fills memory from a stream, with progress from 0 to 1.
/// @throws std::runtime_error when the stream ends early
/// @throws ReadCancelled
void ReadBytes(const std::string& path, ByteStream& stream, void* destination,
  std::uint64_t byteCount, ReadProgress& progress);

/// Turns values from the byte order of a file into the machine's.
void SwapToHostOrder(bool fileIsBigEndian, vtkImageData* image);

}

#endif
