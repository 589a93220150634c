#ifndef Varimarch_Readers_Paging_SummaryFile_h
#define Varimarch_Readers_Paging_SummaryFile_h

#include "Core/Fields/VolumeSummary.h"
#include "Readers/VolumeFile.h"

#include <cstdint>
#include <memory>
#include <string>

namespace varimarch
{

/// Voxels of a file or folder whose summary is wanted.
struct SummarizedVoxels
{
  const BrickSource& source;
  int scalarType;    ///< the VTK type of the source's voxels
  std::string path;  ///< the file or folder
  std::string place; ///< path of the kept summary, without its ending
  std::string stamp; ///< differs after the voxels were written; empty if that is not known
  std::uint64_t mostMemoryBytes;
  int side; ///< cells along each side of a brick
};

/// True if making a summary, which has a tenth of the voxels' bytes, needs more reading than that:
/// voxels that are not stored are not read.
bool NeedsMuchReading(const SummarizedVoxels& voxels);

/// A text that tells the voxels of a file from others: its size and time, and samples of it.
/// @param offset  offset of the first voxel
std::string StampOfFile(const std::string& path, std::uint64_t offset);

/// The summary of voxels that MadeSummary kept; null if there is none with this stamp.
/// @throws std::runtime_error if the bricks need more than half of the memory
std::shared_ptr<const VolumeSummary> KeptSummary(const SummarizedVoxels& voxels);

/// Makes the summary of voxels. If this needs more reading than the summary itself, it is kept
/// beside the file, as `place` with ".varimarch-ranges", or in the user's folder for such files if
/// the file's cannot be written.
/// @throws std::runtime_error if the file cannot be read
/// @throws ReadCancelled
std::shared_ptr<const VolumeSummary> MadeSummary(
  const SummarizedVoxels& voxels, ReadProgress& progress);

/// The user's folder for files that can be made anew at any time; empty if the user has none.
std::string CacheFolder();

}

#endif
