#ifndef Varimarch_Readers_Paging_ChunkedVoxels_h
#define Varimarch_Readers_Paging_ChunkedVoxels_h

#include "Core/Blocks/VoxelUnits.h"
#include "Readers/Paging/PagedVoxels.h"

#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace varimarch
{

/// Addresses whose pages a thread of this process provides when another touches them, by Linux's
/// userfaultfd(2). A thread that touches a page which is not there waits until it is put there.
///
/// Pages of Put() report their first write, those of PutZeros() do not. The addresses are missing
/// in a process that is forked. System calls that are given addresses whose page is not there fail,
/// unless the user may let them wait (vm.unprivileged_userfaultfd).
class PageFaults
{
public:
  /// The reason why this cannot be had here, as the rest of a sentence; empty if it can.
  static const std::string& Obstacle();

  /// @param pages  anonymous memory of this process, to be unmapped after this object's end
  /// @throws std::runtime_error if the system refuses
  PageFaults(char* pages, std::size_t byteCount);
  ~PageFaults();
  PageFaults(const PageFaults&) = delete;
  PageFaults& operator=(const PageFaults&) = delete;

  struct Fault
  {
    char* page;
    bool isFirstWrite; ///< true if the page is there, and somebody waits to write to it
  };

  /// Waits for the next fault; none after Stop().
  std::optional<Fault> Next();
  void Stop();

  /// Puts pages at their place, and lets those go on who wait for them.
  /// @param byteCount  whole pages
  void Put(char* pages, const char* bytes, std::size_t byteCount);

  /// Puts pages of zeros, which take no memory until they are written.
  void PutZeros(char* pages, std::size_t byteCount);

  /// Lets those go on who wait for a page that is there.
  void Wake(char* page);
  void AllowWriting(char* page);

private:
  int faults;
  int stop;
};

/// The voxels of a volume in chunks as an image in the address space. Threads read a unit of them
/// when one of its pages is touched, and whoever touches it waits. Pages of zeros need no memory
/// and are never dropped, so that they may be written without notice. A unit of which another page
/// was written stays in memory as a whole.
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
  /// @param summary  the facts about that level
  /// @throws std::runtime_error if the system refuses
  ChunkedVoxels(std::unique_ptr<const BrickSource> source,
    std::shared_ptr<const VolumeSummary> summary, const std::string& path,
    std::uint64_t mostMemoryBytes);
  ~ChunkedVoxels() override;

  std::string Problem() const override;
  const VoxelUnits* Units() const override { return &this->units; }
  bool AreInForkedProcesses() const override { return false; }
  std::vector<Part> DroppableParts(const PageMap& map, std::uint64_t now) override;
  std::size_t Drop(std::size_t index, const PageMap& map) override;

private:
  enum class State
  {
    Missing,
    Coming, ///< a thread reads it
    There
  };

  struct Unit
  {
    State state = State::Missing;
    bool isWritten = false;         ///< true if a page was, other than one of zeros
    std::uint64_t readAt = 0;       ///< time of the steady clock
    std::size_t droppableBytes = 0; ///< memory of its pages that are not of zeros
    std::vector<bool> areZeros;     ///< for each page, true if it was put there as zeros
  };

  /// The pages of a unit in one of its slices.
  struct Pages
  {
    char* bytes;
    std::size_t first; ///< number of the first in the unit
    std::size_t count;
  };

  void Serve();
  void Stop();
  State Begin(std::size_t unit);
  void Provide(std::size_t unit);
  bool IsOfZeros(const BrickSource::Box& box) const;
  std::vector<char> VoxelsOf(const BrickSource::Box& box) const;
  void ReadColumns(const BrickSource::Box& columns, std::vector<char>& rows) const;
  void PutVoxels(std::size_t unit);
  void PutPages(const Pages& pages, const std::vector<char>& bytes, Unit& unit);
  void PutZeros(std::size_t unit);
  std::vector<Pages> PagesOf(std::size_t unit) const;

  std::unique_ptr<const BrickSource> source;
  std::shared_ptr<const VolumeSummary> summary;
  std::size_t voxelBytes;
  VoxelUnits units;
  std::optional<PageFaults> faults;
  mutable std::mutex mutex; ///< held to change states, to drop pages, and for the problem
  std::size_t unitsToKeep;  ///< so many of the newest units are not dropped
  std::vector<Unit> states; ///< the bytes and pages of a unit belong to the thread that reads it
  std::string problem;
  std::vector<std::thread> servers;
};

}

#endif
