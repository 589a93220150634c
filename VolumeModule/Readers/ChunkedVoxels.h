#ifndef Varimarch_Readers_ChunkedVoxels_h
#define Varimarch_Readers_ChunkedVoxels_h

#include "Core/Blocks/VoxelUnits.h"
#include "Readers/PageFaults.h"
#include "Readers/PagedVoxels.h"

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace varimarch
{

/// The voxels of a volume in chunks as an image in the address space. A thread reads a unit of them
/// when one of its pages is touched, and whoever touches it waits. They may be written; a unit with
/// such a page stays in memory.
///
/// Voxels that cannot be read are 0; Problem() then says why.
class ChunkedVoxels : public PagedVoxels
{
public:
  /// The reason why voxels cannot be had so, as the rest of a sentence about them; empty if they
  /// can.
  /// @param mostMemoryBytes  memory that the program may use
  static std::string Obstacle(
    const BrickSource::Level& level, std::size_t voxelBytes, std::uint64_t mostMemoryBytes);

  /// @param source  its level 0 is read, for which there is no obstacle
  /// @throws std::runtime_error if the system refuses
  ChunkedVoxels(std::unique_ptr<const BrickSource> source, const std::string& path,
    std::uint64_t mostMemoryBytes);
  ~ChunkedVoxels() override;

  std::string Problem() const override;
  bool AreInForkedProcesses() const override { return false; }
  std::vector<Part> DroppableParts(const PageMap& map, std::uint64_t now) override;
  std::size_t Drop(std::size_t index, const PageMap& map) override;

private:
  enum class State
  {
    Missing,
    Read,
    Kept ///< written, or zeros that need no memory
  };

  struct Unit
  {
    State state = State::Missing;
    std::uint64_t readAt = 0; ///< time of the steady clock
  };

  void Serve();
  void Provide(std::size_t unit);
  bool IsOfZeros(std::size_t unit) const;
  std::vector<char> VoxelsOf(const BrickSource::Box& box) const;
  void PutVoxels(std::size_t unit);
  void PutZeros(std::size_t unit);
  std::size_t BytesOf(std::size_t unit) const;

  std::unique_ptr<const BrickSource> source;
  std::size_t voxelBytes;
  VoxelUnits units;
  std::optional<PageFaults> faults;
  mutable std::mutex mutex; ///< held to change states, to drop pages, and for the problem
  std::vector<Unit> states;
  std::string problem;
  std::thread server;
};

}

#endif
