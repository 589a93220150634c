#include "Readers/Paging/PagedPyramid.h"

#include "Readers/Paging/ChunkedVoxels.h"
#include "Readers/Paging/MappedVoxels.h"
#include "Readers/VoxelLayout.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <glm/common.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace varimarch
{

namespace
{

/// The place of a level's voxels among those of another.
struct Placing
{
  glm::dvec3 first;
  glm::dvec3 scale;
};

/// Nothing for a level with other axes.
std::optional<Placing> PlacingOf(const ImageGeometry& level, const ImageGeometry& other)
{
  constexpr double Rounding = 1e-6;
  const glm::dmat3 otherFromMm = glm::inverse(other.axesMm);
  const glm::dmat3 axes = otherFromMm * level.axesMm;
  const glm::dvec3 scale(axes[0][0], axes[1][1], axes[2][2]);
  for (int i = 0; i < 9; ++i)
  {
    if (i % 4 != 0 && !(glm::abs(axes[i / 3][i % 3]) < Rounding))
    {
      return std::nullopt;
    }
  }
  return glm::all(glm::greaterThan(scale, glm::dvec3(0.0)))
    ? std::optional(Placing{ otherFromMm * (level.originMm - other.originMm), scale })
    : std::nullopt;
}

/// The side of the bricks of a level. Those of a coarser level cover as much as those of the
/// finest, so that they are about as many, or less along axes that are scaled less.
int SideOfFinest(const DecodedPyramid& pyramid, std::size_t level, std::uint64_t mostBytes)
{
  constexpr std::size_t MostCoarser = 3;
  const auto& levels = pyramid.Levels();
  const std::size_t coarser = std::min(levels.size() - 1 - level, MostCoarser);
  return SideOfBricks(levels[level], pyramid.Type(), mostBytes / (1 + coarser));
}

/// True if what holds for the values of a volume holds for those of a level.
bool IsWithin(const VolumeSummary& level, const VolumeSummary& volume)
{
  return level.smallest >= volume.smallest && level.largest <= volume.largest &&
    (level.areFinite || !volume.areFinite);
}

}

PagedPyramid::PagedPyramid(
  const PyramidOrder& order, std::shared_ptr<const DecodedPyramid> newPyramid, std::size_t level)
  : order(order)
  , pyramid(std::move(newPyramid))
  , level(level)
  , mostBytes(MostMemoryBytes(order.options))
  , side(SideOfFinest(*this->pyramid, level, this->mostBytes / 2))
  , source(std::make_unique<DecodedLevel>(this->pyramid, int(level)))
  , summary(KeptSummary(this->Summarized(*this->source, level, this->side)))
{
}

SummarizedVoxels PagedPyramid::Summarized(
  const DecodedLevel& ofLevel, std::size_t number, int sideOfBricks) const
{
  const std::string name = std::to_string(number) + "." +
    std::to_string(this->order.options.channel) + "." + std::to_string(this->order.options.time);
  return { ofLevel, this->pyramid->Form().scalarType, this->order.path,
    this->order.path + "." + name, ofLevel.Stamp(), this->mostBytes, sideOfBricks };
}

vtkSmartPointer<vtkImageData> PagedPyramid::Image(ReadProgress& progress)
{
  const PyramidForm& form = this->pyramid->Form();
  if (!this->summary)
  {
    ReadProgress part = this->PartOf(this->level, progress);
    this->summary = MadeSummary(this->Summarized(*this->source, this->level, this->side), part);
  }
  std::uint64_t bytesLeft = this->mostBytes / 2;
  bytesLeft -=
    std::min(bytesLeft, BytesOfBricks(form.levels[this->level], this->pyramid->Type(), this->side));
  std::vector<PagedLevel> coarser;
  for (std::size_t number = this->level + 1; number < form.levels.size(); ++number)
  {
    ReadProgress part = this->PartOf(number, progress);
    if (std::optional<PagedLevel> one = this->Coarser(number, bytesLeft, part))
    {
      coarser.push_back(std::move(*one));
    }
  }
  auto voxels = std::make_unique<ChunkedVoxels>(
    std::move(this->source), this->summary, this->order.path, this->mostBytes);
  voxels->SetCoarser(std::move(coarser));
  return PagedImage(std::move(voxels), { form.levels[this->level].dimensions, form.scalarType, 1 },
    this->summary, this->mostBytes);
}

// Each level is taken to have an eighth of the voxels of the finer one.
ReadProgress PagedPyramid::PartOf(std::size_t number, ReadProgress& progress) const
{
  const double finer = double(number - this->level);
  return progress.Part(1.0 - std::pow(0.125, finer), 1.0 - std::pow(0.125, finer + 1.0));
}

std::optional<PagedLevel> PagedPyramid::Coarser(
  std::size_t number, std::uint64_t& bytesLeft, ReadProgress& progress) const
{
  constexpr int LeastSide = 2;
  constexpr std::uint64_t NoBoundOfItsOwn = std::numeric_limits<std::uint64_t>::max();
  const PyramidForm& form = this->pyramid->Form();
  const BrickSource::Level& level = form.levels[number];
  const glm::ivec3 voxelCount(level.dimensions[0], level.dimensions[1], level.dimensions[2]);
  const auto placing = PlacingOf(form.geometries[number], form.geometries[this->level]);
  const auto voxelBytes = std::size_t(vtkDataArray::GetDataTypeSize(form.scalarType));
  const bool isFiner =
    placing && glm::all(glm::lessThan(placing->scale, glm::dvec3(double(this->side))));
  if (!isFiner || !ChunkedVoxels::Obstacle(level, voxelBytes, this->mostBytes).empty())
  {
    return std::nullopt;
  }
  const glm::dvec3& scale = placing->scale;
  // Bricks that are longer than those of the voxels would join what lies in several of them.
  const int ownSide = std::max(
    LeastSide, int(std::lround(double(this->side) / std::max({ scale.x, scale.y, scale.z }))));
  const std::uint64_t ofBricks = BytesOfBricks(level, this->pyramid->Type(), ownSide);
  if (ofBricks > bytesLeft)
  {
    return std::nullopt;
  }
  auto ofLevel = std::make_unique<DecodedLevel>(this->pyramid, int(number));
  const SummarizedVoxels summarized = this->Summarized(*ofLevel, number, ownSide);
  std::shared_ptr<const VolumeSummary> facts = KeptSummary(summarized);
  facts = facts ? facts : MadeSummary(summarized, progress);
  if (!IsWithin(*facts, *this->summary))
  {
    return std::nullopt;
  }
  bytesLeft -= ofBricks;
  const std::uint64_t ownBytes = this->mostBytes / 4; // each keeps a part of its own
  auto voxels =
    std::make_unique<ChunkedVoxels>(std::move(ofLevel), facts, this->order.path, ownBytes);
  const vtkSmartPointer<vtkImageData> image =
    PagedImage(std::move(voxels), { level.dimensions, form.scalarType, 1 }, facts, NoBoundOfItsOwn);
  return PagedLevel{ image->GetPointData()->GetScalars(), voxelCount, placing->first, scale };
}

}
