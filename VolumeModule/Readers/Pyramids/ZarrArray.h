#ifndef Varimarch_Readers_Pyramids_ZarrArray_h
#define Varimarch_Readers_Pyramids_ZarrArray_h

#include "Core/Blocks/BrickSource.h"
#include "Readers/Pyramids/ArrayAxes.h"
#include "Readers/Pyramids/VoxelPyramid.h"
#include "Readers/Pyramids/ZarrHeader.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace varimarch
{

/// An array of Zarr version 2: a folder with a description in JSON and a file for each chunk. See
/// https://zarr-specs.readthedocs.io/en/latest/v2/v2.0.html
class ZarrArray
{
public:
  /// @throws std::runtime_error if the folder has no such array, or one that cannot be read
  explicit ZarrArray(const std::string& folder);

  const ZarrHeader& Header() const { return this->header; }

  /// Reads a box of the volume, in the machine's byte order. All processors decompress chunks.
  /// @returns the number of chunks without a file, whose voxels have the fill value
  /// @throws std::runtime_error if a chunk is damaged or cannot be in memory
  std::int64_t Read(
    const ArraySelection& selection, const BrickSource::Box& box, void* voxels) const;

  /// Looks for the files of the chunks that a volume needs.
  /// @param size  the number of the volume's voxels along each axis
  StoredChunks Stored(
    const ArraySelection& selection, const std::array<std::int64_t, 3>& size) const;

private:
  /// The part of a box that is in one chunk.
  struct Part
  {
    std::string path;                     ///< file of the chunk
    std::array<std::int64_t, 3> size;     ///< voxels
    std::int64_t chunkOffset;             ///< place of the first voxel, in values
    std::int64_t boxOffset;               ///< the same in the box
    std::array<std::int64_t, 3> boxSteps; ///< from a voxel of the box to the next, in values
  };

  std::string ChunkPath(const std::vector<std::int64_t>& index) const;
  std::vector<std::int64_t> ChunkSteps() const;
  Part PartIn(const std::array<std::int64_t, 3>& chunkIndex, const ArraySelection& selection,
    const BrickSource::Box& box) const;
  std::vector<Part> PartsOf(const ArraySelection& selection, const BrickSource::Box& box) const;
  bool ReadPart(const Part& part, const ArraySelection& selection, char* voxels) const;

  std::string folder;
  ZarrHeader header;
  std::int64_t valueBytes;
};

}

#endif
