#ifndef Varimarch_Readers_Decoder_DecodedLevel_h
#define Varimarch_Readers_Decoder_DecodedLevel_h

#include "Readers/Decoder/DecodedPyramid.h"

#include <memory>
#include <string>
#include <vector>

namespace varimarch
{

/// One level of a volume in levels as a source of its own, which knows the chunks that are stored.
class DecodedLevel : public BrickSource
{
public:
  /// Looks for the chunks.
  /// @throws std::runtime_error with one sentence if they cannot be found
  DecodedLevel(std::shared_ptr<const DecodedPyramid> pyramid, int level);

  const std::vector<Level>& Levels() const override { return this->levels; }
  VoxelType Type() const override { return this->pyramid->Type(); }
  /// Fails too if a chunk is gone that was stored.
  void Read(int, const Box& box, void* voxels) const override;

  /// Whole chunks.
  Box Occupied(const Box& box) const override;
  double Fill() const override { return this->chunks.fill; }

  /// The number of chunks that are not stored.
  std::int64_t MissingChunks() const;

  /// See StoredChunks.
  const std::string& Stamp() const { return this->chunks.stamp; }

private:
  /// Calls take(index of a chunk, whether it is stored) for the chunks that a box lies in.
  template <class Take>
  void EachChunk(const Box& box, Take take) const;

  std::shared_ptr<const DecodedPyramid> pyramid;
  int level;
  std::vector<Level> levels; ///< only this one
  StoredChunks chunks;
};

}

#endif
