#ifndef Varimarch_Readers_VoxelFile_h
#define Varimarch_Readers_VoxelFile_h

#include "Readers/Packed/ByteStream.h"
#include "Readers/VolumeFile.h"
#include "Readers/VoxelLayout.h"

#include <vtkType.h>

#include <cstdint>
#include <string>
#include <vector>

namespace varimarch
{

enum class VoxelEncoding
{
  Binary,
  Text ///< decimal numbers separated by whitespace or commas
};

/// The condition under which voxels are mapped, if the file has them as they are in memory.
struct Mapping
{
  /// Memory that the program may use [bytes]. Voxels that need more than a quarter of it are
  /// mapped. 0: voxels are always read.
  std::uint64_t mostMemoryBytes = 0;
  PreviewWish* preview = nullptr; ///< see ReadOptions
};

Mapping MappingOf(const ReadOptions& options);

/// Location and encoding of the voxels.
struct VoxelFile
{
  /// A data offset that means: the voxels end with the file.
  static constexpr std::int64_t FromEnd = -1;

  std::vector<std::string> paths; ///< files that hold equal parts, in order
  std::int64_t volumeCount = 1;   ///< number of volumes in all files
  std::int64_t volume = 0;        ///< the volume to read, counted from 0
  /// Number of adjacent values of one volume, if the volumes of a single file alternate; 0 if each
  /// volume is in one piece.
  std::int64_t alternation = 0;
  VoxelEncoding encoding = VoxelEncoding::Binary;
  Compression compression = Compression::None;
  bool bigEndian = false;
  bool planar = false;         ///< all values of component 0, then all of component 1, and so on
  std::int64_t fileOffset = 0; ///< bytes to skip in each file
  std::int64_t lineSkip = 0;   ///< lines to skip after them
  std::int64_t dataOffset = 0; ///< bytes to skip after decompression, or FromEnd
  KeptStream* kept = nullptr;  ///< the stream behind the volume that was read last, or null
  std::string conversion;      ///< the work on the voxels once they are read, such as "rescaled"
  Mapping mapping;
};

/// Reads the voxels into a new image at the origin with spacing 1, or maps them (MappedVoxels.h).
/// Sizes are checked against the memory and the files before memory is allocated.
/// @throws std::runtime_error if the files hold less than the layout promises, or invalid data
/// @throws ReadCancelled
vtkSmartPointer<vtkImageData> ReadVoxels(
  const VoxelFile& file, const VoxelLayout& layout, ReadProgress& progress);

/// Fills memory from a stream, with progress from 0 to 1.
/// @throws std::runtime_error if the stream ends early
/// @throws ReadCancelled
void ReadBytes(const std::string& path, ByteStream& stream, void* destination,
  std::uint64_t byteCount, ReadProgress& progress);

#ifdef VTK_WORDS_BIGENDIAN
constexpr bool HostIsBigEndian = true;
#else
constexpr bool HostIsBigEndian = false;
#endif

/// Converts values from the file's byte order to the machine's.
void SwapToHostOrder(bool fileIsBigEndian, vtkImageData* image);

}

#endif
