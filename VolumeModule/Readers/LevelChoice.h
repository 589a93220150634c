#ifndef Varimarch_Readers_LevelChoice_h
#define Varimarch_Readers_LevelChoice_h

#include "Readers/Decoder/DecodedPyramid.h"
#include "Readers/VoxelLayout.h"

#include <cstddef>
#include <memory>
#include <string>

namespace varimarch
{

/// The voxels of a level.
VoxelLayout LayoutOf(const PyramidForm& form, std::size_t level);

double BytesOf(const VoxelLayout& layout);

/// Voxels that may be read as a whole: half of the memory, or of what is free of it, is left to
/// what is made of them.
double MostReadBytes(const ReadOptions& options);

/// The reason why the voxels of a level cannot stay in their chunks until they are needed, as the
/// rest of a sentence about them; empty if they can.
std::string ObstacleToPaging(
  const PyramidForm& form, std::size_t level, const ReadOptions& options);

/// The level that is read.
struct LevelChoice
{
  std::size_t level;
  std::string reason; ///< the sentence that says why it is not the finest; empty if it is
};

/// The level that was asked for, or the finest that can be read or stay in its chunks, and whose
/// ranges are made of at most 100 GB or kept already; the coarsest if there is none.
/// @throws std::runtime_error if a level was asked for that does not exist
LevelChoice LevelToRead(
  const PyramidOrder& order, const std::shared_ptr<const DecodedPyramid>& pyramid);

}

#endif
