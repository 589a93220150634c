#include "Core/Quality/BlockLooks.h"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace varimarch
{

namespace
{

LookBetween BothOf(const LookBetween& one, const LookBetween& other)
{
  return { glm::min(one.least, other.least), glm::max(one.most, other.most) };
}

// Few enough blocks that every ray crosses few, and that they take little memory, however thin the
// volume is.
BlockLevels BlocksOf(const glm::ivec3& bricks)
{
  constexpr double MostBlocks = 1 << 21;
  BlockLevels blocks;
  blocks.count = bricks;
  while (double(blocks.count.x) * blocks.count.y * blocks.count.z > MostBlocks)
  {
    ++blocks.side;
    blocks.count = (bricks + blocks.side - 1) / blocks.side;
  }
  return blocks;
}

/// Calls visit(begin, end) for each row of a box of numbers, `first` to `last`, in an array.
template <class Visit>
void ForEachRow(
  const glm::ivec3& first, const glm::ivec3& last, const glm::ivec3& count, Visit visit)
{
  for (int z = first.z; z <= last.z; ++z)
  {
    for (int y = first.y; y <= last.y; ++y)
    {
      const std::size_t row = (std::size_t(z) * count.y + y) * count.x;
      visit(row + first.x, row + last.x + 1);
    }
  }
}

/// The range of the bricks of a block; not finite if that of one of them is not.
BrickRanges::Steps StepsOf(const BrickRanges& ranges, const glm::ivec3& block, int side)
{
  const glm::ivec3 bricks = ranges.BrickCount();
  BrickRanges::Steps all{ 65535, 0 };
  bool areFinite = true;
  ForEachRow(block * side, glm::min((block + 1) * side, bricks) - 1, bricks,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t brick = begin; brick < end; ++brick)
      {
        const BrickRanges::Steps steps = ranges[brick];
        areFinite = areFinite && steps.IsFinite();
        all = { std::min(all.smallest, steps.smallest), std::max(all.largest, steps.largest) };
      }
    });
  return areFinite ? all : BrickRanges::Steps{ 1, 0 };
}

/// Extremes of the means between which the level of a block is interpolated: its own and those
/// around it.
struct MeansBetween
{
  double least = std::numeric_limits<double>::max();
  double most = std::numeric_limits<double>::lowest();
  bool areFinite = true;
};

template <class Scalar>
MeansBetween MeansOf(const CoarseLevel& level, const glm::ivec3& block, int side)
{
  const auto* const means = reinterpret_cast<const Scalar*>(level.voxels.data());
  const glm::ivec3 last = level.voxelCount - 1;
  MeansBetween all;
  ForEachRow(glm::clamp(block * side - 1, glm::ivec3(0), last),
    glm::clamp((block + 1) * side, glm::ivec3(0), last), level.voxelCount,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const double mean = double(means[i]);
        const bool isFinite = std::isfinite(mean);
        all.areFinite = all.areFinite && isFinite;
        all.least = isFinite ? std::min(all.least, mean) : all.least;
        all.most = isFinite ? std::max(all.most, mean) : all.most;
      }
    });
  return all;
}

}

EntryExtremes::EntryExtremes(const std::vector<glm::vec4>& entries)
  : levels(1)
{
  std::transform(entries.begin(), entries.end(), std::back_inserter(this->levels[0]),
    [](const glm::vec4& entry) {
      return LookBetween{ entry, entry };
    });
  for (std::size_t length = 2; length <= entries.size(); length *= 2)
  {
    const std::vector<LookBetween>& halves = this->levels.back();
    std::vector<LookBetween> level;
    for (std::size_t i = 0; i + length <= entries.size(); ++i)
    {
      level.push_back(BothOf(halves[i], halves[i + length / 2]));
    }
    this->levels.push_back(std::move(level));
  }
}

LookBetween EntryExtremes::Of(int first, int last) const
{
  const int level = std::ilogb(double(last - first + 1));
  return BothOf(this->levels[std::size_t(level)][std::size_t(first)],
    this->levels[std::size_t(level)][std::size_t(last + 1 - (1 << level))]);
}

BlockLooks::Entries BlockLooks::Around(const Entries& one, const Entries& other)
{
  return { std::min(one.first, other.first), std::max(one.last, other.last) };
}

BlockLooks::BlockLooks(const VolumeSummary& summary, VoxelType type, const OpticalTable& table,
  std::optional<double> brightest)
  : extremes(table.entries)
  , brightest(brightest)
  , coarse(BlocksOf(summary.ranges.BrickCount()))
{
  constexpr double Middle = 0.5 * (CoarseLevel::Side - 1.0);
  this->lastMeans =
    glm::ivec3((double(CoarseLevel::Side) * glm::dvec3(summary.coarse.voxelCount - 1) + Middle) /
      this->CellsPerSide());
  const glm::ivec3 count = this->coarse.count;
  this->coarse.ofBlocks.resize(std::size_t(count.x) * count.y * count.z);
  this->blocks.resize(this->coarse.ofBlocks.size());
  ByVoxelType(type, [&](auto voxel) { this->FindEntries<decltype(voxel)>(summary, table); });
}

template <class Scalar>
void BlockLooks::FindEntries(const VolumeSummary& summary, const OpticalTable& table)
{
  const double last = double(table.entries.size()) - 1.0;
  const IndexInTable ofStep =
    IndexOf(table, last, summary.ranges.ValuePerStep(), summary.ranges.FirstValue());
  const IndexInTable ofValue = IndexOf(table, last);
  const auto entries = [last](const IndexInTable& index, double smallest, double largest)
  {
    const auto at = [&](double number)
    { return std::clamp(index.bias + number * index.scale, 0.0, last); };
    return Entries{ int(std::floor(at(smallest))), int(std::ceil(at(largest))) };
  };
  const glm::ivec3 count = this->coarse.count;
  tbb::parallel_for(0, count.y * count.z,
    [&](int row)
    {
      for (int x = 0; x < count.x; ++x)
      {
        const glm::ivec3 place(x, row % count.y, row / count.y);
        const BrickRanges::Steps steps = StepsOf(summary.ranges, place, this->coarse.side);
        const MeansBetween means = MeansOf<Scalar>(summary.coarse, place, this->coarse.side);
        Block& block = this->blocks[this->coarse.PlaceOf(place)];
        block.hasGaps = !steps.IsFinite() || !means.areFinite;
        block.voxels = steps.IsFinite() ? entries(ofStep, steps.smallest, steps.largest)
                                        : Entries{ 0, int(last) };
        block.both = means.least > means.most
          ? block.voxels
          : Around(block.voxels, entries(ofValue, means.least, means.most));
      }
    });
}

BlockLevels BlockLooks::Begun() const
{
  BlockLevels levels = this->coarse;
  for (std::size_t place = 0; place < levels.ofBlocks.size(); ++place)
  {
    levels.ofBlocks[place] =
      this->OfVoxels(place).most.a > 0.0f ? BlockLevel::Coarse : BlockLevel::Nothing;
  }
  return levels;
}

bool BlockLooks::LevelEndsIn(const glm::ivec3& block) const
{
  return glm::any(glm::lessThanEqual(block, glm::ivec3(0))) ||
    glm::any(glm::greaterThanEqual(block, this->lastMeans));
}

LookBetween BlockLooks::LookOf(const Entries& entries, bool hasGaps) const
{
  LookBetween look = this->extremes.Of(entries.first, entries.last);
  look.least.a = hasGaps ? 0.0f : look.least.a;
  if (this->brightest)
  {
    look.least = { 0.0f, 0.0f, 0.0f, look.least.a };
    look.most = glm::vec4(glm::vec3(float(*this->brightest)), look.most.a);
  }
  return look;
}

}
