#ifndef Varimarch_Readers_Paging_PagedPyramid_h
#define Varimarch_Readers_Paging_PagedPyramid_h

#include "Core/Fields/VolumeSummary.h"
#include "Readers/Decoder/DecodedPyramid.h"
#include "Readers/Paging/PagedVoxels.h"
#include "Readers/Paging/SummaryFile.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

namespace varimarch
{

/// A level of a volume in levels whose chunks are read when they are needed, with those of its
/// coarser levels that are finer than the means of its summary.
class PagedPyramid
{
public:
  /// Looks for the chunks, and for a kept summary.
  /// @param level  a level that can stay in its chunks
  /// @throws std::runtime_error if they cannot be found, or the memory does not suffice for bricks
  PagedPyramid(
    const PyramidOrder& order, std::shared_ptr<const DecodedPyramid> pyramid, std::size_t level);

  /// False if all voxels have to be read before there is an image.
  bool IsSummarized() const { return this->summary != nullptr; }

  std::int64_t MissingChunks() const { return this->source->MissingChunks(); }

  /// The image of the level. May be called once.
  /// @throws std::runtime_error if the voxels cannot be read
  /// @throws ReadCancelled
  vtkSmartPointer<vtkImageData> Image(ReadProgress& progress);

private:
  SummarizedVoxels Summarized(const DecodedLevel& ofLevel, std::size_t number, int side) const;
  /// The progress of a level among all levels.
  ReadProgress PartOf(std::size_t number, ReadProgress& progress) const;
  /// A coarser level; none if it is no finer than the means, cannot be drawn in their place, or has
  /// bricks that need more memory than is left.
  /// @param bytesLeft  memory for bricks [bytes]; it becomes less by those of the level
  std::optional<PagedLevel> Coarser(
    std::size_t number, std::uint64_t& bytesLeft, ReadProgress& progress) const;

  const PyramidOrder& order;
  std::shared_ptr<const DecodedPyramid> pyramid;
  std::size_t level;
  std::uint64_t mostBytes; ///< memory that the program may use
  int side;                ///< cells along each side of a brick
  std::unique_ptr<DecodedLevel> source;
  std::shared_ptr<const VolumeSummary> summary;
};

}

#endif
