#ifndef Varimarch_Readers_SummaryFile_h
#define Varimarch_Readers_SummaryFile_h

#include "Core/Fields/VolumeSummary.h"
#include "Readers/VolumeFile.h"
#include "Readers/VoxelLayout.h"

#include <cstdint>
#include <memory>
#include <string>

namespace varimarch
{

/// Voxels of a file whose summary is wanted.
struct SummarizedVoxels
{
  std::string path;
  VoxelLayout layout;   ///< one component of a type of VoxelTypeOf
  std::uint64_t offset; ///< offset of the first voxel in the file
  std::uint64_t mostMemoryBytes;
};

/// The summary of a file's voxels. It is kept beside the file, as its name with
/// ".varimarch-ranges", or in the user's folder for such files if the file's cannot be written, and
/// is made anew unless size, time and samples of the file are those that it was made of.
/// @throws std::runtime_error if the file cannot be read, or its bricks need more than half of the
/// memory
/// @throws ReadCancelled
std::shared_ptr<const VolumeSummary> KeptSummary(
  const SummarizedVoxels& voxels, ReadProgress& progress);

/// The user's folder for files that can be made anew at any time; empty if the user has none.
std::string CacheFolder();

}

#endif
