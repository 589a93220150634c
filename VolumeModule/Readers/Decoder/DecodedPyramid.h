#ifndef Varimarch_Readers_Decoder_DecodedPyramid_h
#define Varimarch_Readers_Decoder_DecodedPyramid_h

#include "Readers/Pyramids/VoxelPyramid.h"
#include "VarimarchVolumeModule.h"

#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace varimarch
{

class Conversation;

class DecoderProcess;

/// A volume in levels that decoders read, one for each thread that reads at the same time. It is in
/// no session: its decoders live as long as it does.
class VARIMARCHVOLUME_EXPORT DecodedPyramid : public BrickSource
{
public:
  /// Opens the volume.
  /// @throws std::runtime_error with one sentence if it cannot be read
  DecodedPyramid(const PyramidOrder& order, ReadProgress& progress);
  ~DecodedPyramid() override;

  /// The file or folder.
  const std::string& Path() const { return this->order.path; }
  const PyramidForm& Form() const { return this->form; }

  const std::vector<Level>& Levels() const override { return this->form.levels; }

  /// The stored type, or Float32 for types that packets of rays do not read.
  VoxelType Type() const override;

  /// Voxels of Type().
  void Read(int level, const Box& box, void* voxels) const override
  {
    this->ReadConverted(level, box, voxels);
  }

  /// Voxels of Type().
  /// @returns the number of chunks that the file does not have
  std::int64_t ReadConverted(int level, const Box& box, void* voxels) const;

  /// Voxels of the stored type.
  /// @returns the number of chunks that the file does not have
  /// @throws ReadCancelled
  std::int64_t ReadStored(int level, const Box& box, void* voxels, ReadProgress& progress) const;

  /// The chunks of a level that are stored.
  StoredChunks Stored(int level) const;

private:
  /// Has a conversation with a decoder that is idle, or else with a new one.
  void Ask(ReadProgress& progress, const std::function<void(Conversation&)>& talk) const;
  void TryToAsk(ReadProgress& progress, const std::function<void(Conversation&)>& talk,
    std::unique_ptr<DecoderProcess> process) const;

  PyramidOrder order;
  PyramidForm form;
  mutable std::mutex mutex; ///< held to take and return decoders
  mutable std::vector<std::unique_ptr<DecoderProcess>> idle;
};

/// Opens a file or folder as a volume in levels; null for volumes of other formats.
/// @throws std::runtime_error if it is such a volume and cannot be read
VARIMARCHVOLUME_EXPORT std::unique_ptr<DecodedPyramid> OpenPyramidAt(
  const std::string& path, const ReadOptions& options, ReadProgress& progress);

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
