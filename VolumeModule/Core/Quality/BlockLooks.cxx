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
BlockLevels BlocksOf(const BrickRanges& ranges)
{
  constexpr double MostBlocks = 1 << 21;
  const glm::ivec3 bricks = ranges.BrickCount();
  BlockLevels blocks;
  blocks.count = bricks;
  int side = 1; // bricks
  while (double(blocks.count.x) * blocks.count.y * blocks.count.z > MostBlocks)
  {
    ++side;
    blocks.count = (bricks + side - 1) / side;
  }
  blocks.side = side * ranges.Side();
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

/// The range of bricks, `first` to `last`; not finite if that of one of them is not.
BrickRanges::Steps StepsOf(
  const BrickRanges& ranges, const glm::ivec3& first, const glm::ivec3& last)
{
  BrickRanges::Steps all{ 65535, 0 };
  bool areFinite = true;
  ForEachRow(first, last, ranges.BrickCount(),
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

/// The range of the values that a level has in a box of the volume's grid. Beyond its outermost
/// voxels it has their values.
BrickRanges::Steps StepsIn(
  const MiddleLevel& level, const glm::dvec3& lower, const glm::dvec3& upper)
{
  constexpr double Rounding = 1e-6; // the range of a brick has the values at its faces
  const BrickRanges& ranges = level.summary->ranges;
  const double side = ranges.Side();
  const auto inside = [&](const glm::dvec3& brick)
  { return glm::clamp(glm::ivec3(brick), glm::ivec3(0), ranges.BrickCount() - 1); };
  const auto placeIn = [&](const glm::dvec3& place)
  { return (place - level.first) / (level.scale * side); };
  return StepsOf(ranges, inside(glm::floor(placeIn(lower) + Rounding)),
    inside(glm::ceil(placeIn(upper) - Rounding) - 1.0));
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
  std::optional<double> brightest, const std::vector<MiddleLevel>& middle)
  : extremes(table.entries)
  , brightest(brightest)
  , coarse(BlocksOf(summary.ranges))
  , levelCount(middle.size() + 2)
{
  const double cube = summary.coarse.side;
  this->lastMeans =
    glm::ivec3((cube * glm::dvec3(summary.coarse.voxelCount - 1) + 0.5 * (cube - 1.0)) /
      double(this->coarse.side));
  const glm::ivec3 count = this->coarse.count;
  const auto coarsest = BlockLevel(this->levelCount - 1);
  this->coarse.ofBlocks.resize(std::size_t(count.x) * count.y * count.z, coarsest);
  this->entries.resize(this->coarse.ofBlocks.size() * this->levelCount);
  this->hasGaps.resize(this->coarse.ofBlocks.size());
  ByVoxelType(
    type, [&](auto voxel) { this->FindEntries<decltype(voxel)>(summary, table, middle); });
}

/// The entries of a table between values.
class BlockLooks::EntriesBetween
{
public:
  explicit EntriesBetween(const OpticalTable& table)
    : table(table)
    , last(double(table.entries.size()) - 1.0)
  {
  }

  /// All entries for a range that is not finite.
  Entries OfSteps(const BrickRanges& ranges, const BrickRanges::Steps& steps) const
  {
    const IndexInTable index =
      IndexOf(this->table, this->last, ranges.ValuePerStep(), ranges.FirstValue());
    return steps.IsFinite() ? this->Of(index, steps.smallest, steps.largest)
                            : Entries{ 0, int(this->last) };
  }

  Entries OfValues(double smallest, double largest) const
  {
    return this->Of(IndexOf(this->table, this->last), smallest, largest);
  }

private:
  Entries Of(const IndexInTable& index, double smallest, double largest) const
  {
    const auto at = [&](double number)
    { return std::clamp(index.bias + number * index.scale, 0.0, this->last); };
    return { int(std::floor(at(smallest))), int(std::ceil(at(largest))) };
  }

  const OpticalTable& table;
  double last;
};

template <class Scalar>
void BlockLooks::FindEntries(
  const VolumeSummary& summary, const OpticalTable& table, const std::vector<MiddleLevel>& middle)
{
  const EntriesBetween between(table);
  const glm::ivec3 count = this->coarse.count;
  const int side = this->coarse.side / summary.ranges.Side(); // bricks, or means
  const auto find = [&](const glm::ivec3& block)
  {
    const std::size_t place = this->coarse.PlaceOf(block);
    Entries* const own = &this->entries[place * this->levelCount];
    const BrickRanges::Steps ofVoxels = StepsOf(
      summary.ranges, block * side, glm::min((block + 1) * side, summary.ranges.BrickCount()) - 1);
    own[0] = between.OfSteps(summary.ranges, ofVoxels);
    bool areFinite = ofVoxels.IsFinite();
    for (std::size_t i = 0; i < middle.size(); ++i)
    {
      const glm::dvec3 lower(this->coarse.side * block);
      const BrickRanges::Steps steps = StepsIn(middle[i], lower, lower + double(this->coarse.side));
      areFinite = areFinite && steps.IsFinite();
      own[i + 1] = Around(own[i], between.OfSteps(middle[i].summary->ranges, steps));
    }
    const MeansBetween means = MeansOf<Scalar>(summary.coarse, block, side);
    const std::size_t last = this->levelCount - 1;
    own[last] = means.least > means.most
      ? own[last - 1]
      : Around(own[last - 1], between.OfValues(means.least, means.most));
    this->hasGaps[place] = areFinite && means.areFinite ? 0 : 1;
  };
  tbb::parallel_for(0, count.y * count.z,
    [&](int row)
    {
      for (int x = 0; x < count.x; ++x)
      {
        find({ x, row % count.y, row / count.y });
      }
    });
}

BlockLevels BlockLooks::Begun() const
{
  BlockLevels levels = this->coarse;
  for (std::size_t place = 0; place < levels.ofBlocks.size(); ++place)
  {
    levels.ofBlocks[place] =
      this->OfVoxels(place).most.a > 0.0f ? levels.ofBlocks[place] : BlockLevel::Nothing;
  }
  return levels;
}

bool BlockLooks::LevelEndsIn(const glm::ivec3& block) const
{
  return glm::any(glm::lessThanEqual(block, glm::ivec3(0))) ||
    glm::any(glm::greaterThanEqual(block, this->lastMeans));
}

LookBetween BlockLooks::LookOf(const Entries& between, bool hasGap) const
{
  LookBetween look = this->extremes.Of(between.first, between.last);
  look.least.a = hasGap ? 0.0f : look.least.a;
  if (this->brightest)
  {
    look.least = { 0.0f, 0.0f, 0.0f, look.least.a };
    look.most = glm::vec4(glm::vec3(float(*this->brightest)), look.most.a);
  }
  return look;
}

}
