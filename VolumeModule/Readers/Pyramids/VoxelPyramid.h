#ifndef Varimarch_Readers_Pyramids_VoxelPyramid_h
#define Varimarch_Readers_Pyramids_VoxelPyramid_h

#include "Core/Blocks/BrickSource.h"
#include "Readers/ImageGeometry.h"
#include "Readers/VolumeFile.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace varimarch
{

/// Everything about a volume in levels but its voxels.
struct PyramidForm
{
  std::vector<BrickSource::Level> levels; ///< at least one, from fine to coarse
  std::vector<ImageGeometry> geometries;  ///< one for each level, in LPS [mm]
  int scalarType = 0;                     ///< VTK_SHORT or another VTK type
  std::optional<WindowLevel> windowLevel;
  std::vector<std::string> warnings;
  VolumeTimes times; ///< times of the file, one of which is read
  /// All channels of the file, one of which is read, if it says how many there are.
  std::vector<VolumeChannel> channels;
  std::string otherChannels; ///< the warning that only one of several was read; may be empty
};

/// The chunks of a level that a file or folder has.
struct StoredChunks
{
  /// 1 for each chunk that is there, 0 for others, x fastest; empty if all are there, or if there
  /// are too many to look for them.
  std::vector<std::uint8_t> areThere;
  double fill = 0.0; ///< the value of voxels of the others
  /// A text that differs after something was written to the level; empty if that is not known.
  std::string stamp;
};

/// Chunks of a level that are looked for, which takes several seconds. Of more nothing is known.
constexpr double MostChunksToFind = 4e6;

/// A file or folder with a volume in levels, cut into chunks, that a decoder has opened. It keeps
/// no voxels.
class VoxelPyramid
{
public:
  virtual ~VoxelPyramid() = default;

  const PyramidForm& Form() const { return this->form; }
  void Warn(const std::vector<std::string>& warnings)
  {
    auto& all = this->form.warnings;
    all.insert(all.begin(), warnings.begin(), warnings.end());
  }

  /// Reads the voxels of a box that lies in the level, in the machine's byte order, x fastest.
  /// @returns the number of chunks that the file does not have, whose voxels have its fill value
  /// @throws std::runtime_error if the voxels cannot be read
  virtual std::int64_t Read(int level, const BrickSource::Box& box, void* voxels) = 0;

  /// Looks for the chunks of a level.
  virtual StoredChunks Stored(int level) const = 0;

protected:
  PyramidForm form;
};

/// The formats of volumes in levels.
enum class PyramidFormat : std::uint32_t
{
  Zarr,
  Hdf5
};

/// The volume that a decoder is asked for.
struct PyramidOrder
{
  PyramidFormat format = PyramidFormat::Zarr;
  std::string path;
  ReadOptions options; ///< only the channel and the time are used
};

/// Voxels of a box along each axis, and of all of it.
std::array<std::int64_t, 3> SizeOf(const BrickSource::Box& box);

std::int64_t VoxelCount(const BrickSource::Box& box);

/// True if a box has voxels, all of which lie in the level.
bool LiesIn(const BrickSource::Box& box, const BrickSource::Level& level);

/// The chunks along each axis of a level.
std::array<std::int64_t, 3> ChunkCount(const BrickSource::Level& level);

/// The number that bytes in the machine's order are.
double ValueIn(const std::vector<char>& bytes, int scalarType);

/// Sets the scale of each level from the geometries, and refuses geometries without a size.
/// @param path  path for the error message
void SetScales(const std::string& path, PyramidForm& form);

/// Adds a sentence if a file maps its values by a factor and an offset other than 1 and 0, which is
/// not done while chunks are read.
void WarnOfScale(
  std::optional<double> factor, std::optional<double> offset, std::vector<std::string>& warnings);

/// The bytes of a chunk, or of a box, that has to be in memory as a whole.
/// @param path  path for the error message
/// @throws std::runtime_error if they do not fit in the memory that is free
std::uint64_t CheckedChunkBytes(
  const std::string& path, const std::vector<std::int64_t>& sizes, std::int64_t valueBytes);

/// Open a volume in levels of each format.
/// @throws std::runtime_error with one sentence if it is none that can be read
std::unique_ptr<VoxelPyramid> OpenZarr(const std::string& path, const ReadOptions& options);

std::unique_ptr<VoxelPyramid> OpenHdf5(const std::string& path, const ReadOptions& options);

/// A path such as "brain.h5/volumes/raw", as ilastik writes them: a file, and a data set in it.
struct Hdf5Path
{
  std::string file;
  std::string inner; ///< with a slash at its beginning; empty if the path names no data set
};

/// Splits a path behind the first part that is a regular file. A path without one stays whole.
Hdf5Path Hdf5PathOf(const std::string& path);

}

#endif
