#ifndef Varimarch_Readers_Paging_PagedVoxels_h
#define Varimarch_Readers_Paging_PagedVoxels_h

#include <vtkDataArray.h>
#include <vtkSmartPointer.h>

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace varimarch
{

class PageMap;
struct VolumeSummary;
class VoxelUnits;

/// A coarser level of paged voxels: voxel (i, j, k) is at first + scale * (i, j, k) among them.
struct PagedLevel
{
  vtkSmartPointer<vtkDataArray> scalars; ///< paged too, with a summary
  glm::ivec3 voxelCount;
  glm::dvec3 first;
  glm::dvec3 scale;
};

/// Voxels in the address space that come into memory when they are touched, and whose parts can be
/// dropped again. MappedMemory keeps what is in memory within a bound.
class PagedVoxels
{
public:
  PagedVoxels() = default;
  virtual ~PagedVoxels() = default;
  PagedVoxels(const PagedVoxels&) = delete;
  PagedVoxels& operator=(const PagedVoxels&) = delete;

  void* Bytes() const { return this->pages + this->lead; }

  /// True for an address inside.
  bool Holds(const void* address) const
  {
    const char* const byte = static_cast<const char*>(address);
    return byte >= this->pages && byte < this->pages + this->pageBytes;
  }

  /// The sentence that says why the voxels are not those that they were; empty if they are. The
  /// full stop is missing.
  virtual std::string Problem() const = 0;

  /// The units that come into memory as a whole; null if each page comes alone.
  virtual const VoxelUnits* Units() const { return nullptr; }

  /// True if a process that is forked has the voxels too.
  virtual bool AreInForkedProcesses() const = 0;

  /// Remembers the facts about the voxels.
  /// @param time  time of the last change of the array that has them
  void Describe(std::shared_ptr<const VolumeSummary> newSummary, std::uint64_t time)
  {
    this->summary = std::move(newSummary);
    this->summaryTime = time;
  }

  /// The facts about the voxels; null if the array has changed since.
  std::shared_ptr<const VolumeSummary> Summary(std::uint64_t time) const
  {
    return time == this->summaryTime ? this->summary : nullptr;
  }

  /// Remembers coarser levels, from the finest on.
  void SetCoarser(std::vector<PagedLevel> levels) { this->coarser = std::move(levels); }
  const std::vector<PagedLevel>& Coarser() const { return this->coarser; }

  /// A part of the voxels that is dropped as a whole.
  struct Part
  {
    std::size_t index;
    std::size_t residentBytes; ///< memory that dropping it frees
    std::uint64_t grew;        ///< the time when it last had more in memory than the time before
  };

  /// The parts in memory, without those that were written.
  /// @param now  time of the steady clock
  virtual std::vector<Part> DroppableParts(const PageMap& map, std::uint64_t now) = 0;

  /// Drops a part unless it has been written.
  /// @returns the memory that this frees [bytes]
  virtual std::size_t Drop(std::size_t index, const PageMap& map) = 0;

protected:
  char* pages = nullptr; ///< the part of the address space, in whole pages
  std::size_t pageBytes = 0;
  std::size_t lead = 0; ///< bytes of the first page before the first voxel

private:
  std::shared_ptr<const VolumeSummary> summary;
  std::uint64_t summaryTime = 0;
  std::vector<PagedLevel> coarser;
};

/// The voxels that an address is in; null if there are none.
std::shared_ptr<PagedVoxels> PagedVoxelsAt(const void* address);

}

#endif
