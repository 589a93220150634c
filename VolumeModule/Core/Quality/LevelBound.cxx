#include "Core/Quality/LevelBound.h"

#include "Core/Geometry/CellWalk.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace varimarch
{

namespace
{

/// The extremes of colour and extinction.
struct LookBetween
{
  glm::vec4 least = glm::vec4(0.0f);
  glm::vec4 most = glm::vec4(0.0f);
};

/// Extremes of the entries of a table in any interval, as two overlapping ones whose lengths are
/// powers of two.
class EntryExtremes
{
public:
  explicit EntryExtremes(const std::vector<glm::vec4>& entries)
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
        level.push_back(Both(halves[i], halves[i + length / 2]));
      }
      this->levels.push_back(std::move(level));
    }
  }

  LookBetween Of(int first, int last) const
  {
    const int level = std::ilogb(double(last - first + 1));
    return Both(this->levels[std::size_t(level)][std::size_t(first)],
      this->levels[std::size_t(level)][std::size_t(last + 1 - (1 << level))]);
  }

private:
  static LookBetween Both(const LookBetween& one, const LookBetween& other)
  {
    return { glm::min(one.least, other.least), glm::max(one.most, other.most) };
  }

  std::vector<std::vector<LookBetween>> levels;
};

/// Blocks of bricks with what a ray may meet in them.
class LookBlocks
{
public:
  explicit LookBlocks(const LevelBoundScene& scene)
    : bricks(scene.ranges.BrickCount())
    , side(SideOf(this->bricks))
    , count((this->bricks + this->side - 1) / this->side)
    , looks(std::size_t(this->count.x) * this->count.y * this->count.z)
  {
    const EntryExtremes extremes(scene.table.entries);
    const double lastEntry = double(scene.table.entries.size()) - 1.0;
    const IndexInTable entryOfStep = varimarch::IndexOf(
      scene.table, lastEntry, scene.ranges.ValuePerStep(), scene.ranges.FirstValue());
    tbb::parallel_for(0, this->count.y * this->count.z,
      [&](int row)
      {
        for (int x = 0; x < this->count.x; ++x)
        {
          const glm::ivec3 block(x, row % this->count.y, row / this->count.y);
          const BrickRanges::Steps steps = this->StepsAround(scene.ranges, block);
          const auto entryOf = [&](double step)
          { return std::clamp(entryOfStep.bias + step * entryOfStep.scale, 0.0, lastEntry); };
          LookBetween& look = this->looks[this->PlaceOf(block)];
          look = steps.IsFinite() ? extremes.Of(int(std::floor(entryOf(steps.smallest))),
                                      int(std::ceil(entryOf(steps.largest))))
                                  : extremes.Of(0, int(lastEntry));
          look.least.a = steps.IsFinite() ? look.least.a : 0.0f; // gaps are clear
          this->Widen(block, scene.isLit, look);
        }
      });
  }

  /// @param cell  counted in blocks; outside, that of the nearest block
  const LookBetween& Of(const glm::ivec3& cell) const
  {
    return this->looks[this->PlaceOf(glm::clamp(cell, glm::ivec3(0), this->count - 1))];
  }

  double CellsPerSide() const { return double(this->side) * BrickRanges::CellsPerSide; }

private:
  // Few enough blocks that every ray crosses few.
  static int SideOf(const glm::ivec3& bricks)
  {
    constexpr double MostBlocks = 1 << 21;
    const double all = double(bricks.x) * bricks.y * bricks.z;
    return std::max(1, int(std::ceil(std::cbrt(all / MostBlocks))));
  }

  std::size_t PlaceOf(const glm::ivec3& block) const
  {
    return (std::size_t(block.z) * this->count.y + block.y) * this->count.x + block.x;
  }

  // The range of a block and the bricks around it, on whose means the level depends.
  BrickRanges::Steps StepsAround(const BrickRanges& ranges, const glm::ivec3& block) const
  {
    const glm::ivec3 first = glm::max(block * this->side - 1, 0);
    const glm::ivec3 last = glm::min((block + 1) * this->side, this->bricks - 1);
    BrickRanges::Steps all{ 65535, 0 };
    bool areFinite = true;
    for (int z = first.z; z <= last.z; ++z)
    {
      for (int y = first.y; y <= last.y; ++y)
      {
        const std::size_t row = (std::size_t(z) * this->bricks.y + y) * this->bricks.x;
        for (int x = first.x; x <= last.x; ++x)
        {
          const BrickRanges::Steps steps = ranges[row + x];
          areFinite = areFinite && steps.IsFinite();
          all = { std::min(all.smallest, steps.smallest), std::max(all.largest, steps.largest) };
        }
      }
    }
    return areFinite ? all : BrickRanges::Steps{ 1, 0 };
  }

  // At the faces of the volume the level may end a little earlier.
  void Widen(const glm::ivec3& block, bool isLit, LookBetween& look) const
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const bool isOutermost = block[axis] == 0 || block[axis] == this->count[axis] - 1;
      look.least.a = isOutermost ? 0.0f : look.least.a;
    }
    if (isLit)
    {
      look.least = { 0.0f, 0.0f, 0.0f, look.least.a };
      look.most = { 1.0f, 1.0f, 1.0f, look.most.a };
    }
  }

  glm::ivec3 bricks;
  int side; ///< bricks along a side of a block
  glm::ivec3 count;
  std::vector<LookBetween> looks;
};

/// A part of a ray, and what it meets there.
struct Segment
{
  const LookBetween* look;
  double leastOpacity;
  double mostOpacity;
};

/// The parts of a ray that may be seen, front to back, in a box that is a little larger than the
/// volume.
std::vector<Segment> SegmentsOf(
  const LevelBoundScene& scene, const LookBlocks& blocks, const Ray& rayGrid)
{
  constexpr double BesideVoxels = 2.0;
  constexpr double MostDepth = 20.0;
  const glm::dvec3 size(scene.ranges.BrickCount() * BrickRanges::CellsPerSide);
  const Interval inside = Intersection(
    rayGrid, { glm::dvec3(-BesideVoxels), size + BesideVoxels }, scene.rays.BetweenPlanes(rayGrid));
  const double side = blocks.CellsPerSide();
  const Ray rayInBlocks{ rayGrid.origin / side, rayGrid.direction / side };
  const double mmPerT = glm::length(scene.worldFromGrid * rayGrid.direction);
  std::vector<Segment> segments;
  double leastDepth = 0.0;
  if (inside.IsEmpty())
  {
    return segments;
  }
  WalkCells(rayInBlocks, inside,
    [&](const CellPart& part)
    {
      const LookBetween& look = blocks.Of(part.cell);
      const double mm = (part.t.exit - part.t.enter) * mmPerT;
      if (look.most.a > 0.0f)
      {
        segments.push_back(
          { &look, -std::expm1(-mm * look.least.a), -std::expm1(-mm * look.most.a) });
        leastDepth += mm * look.least.a;
      }
      return leastDepth < MostDepth;
    });
  return segments;
}

double BoundOf(const std::vector<Segment>& segments)
{
  std::array<double, 4> least = {};
  std::array<double, 4> most = {};
  for (auto segment = segments.rbegin(); segment != segments.rend(); ++segment)
  {
    for (int channel = 0; channel < 4; ++channel)
    {
      // The opacity is the composite of a colour of 1.
      const double leastColor = channel < 3 ? double(segment->look->least[channel]) : 1.0;
      const double mostColor = channel < 3 ? double(segment->look->most[channel]) : 1.0;
      double& low = least[std::size_t(channel)];
      double& high = most[std::size_t(channel)];
      const double forLow = leastColor < low ? segment->mostOpacity : segment->leastOpacity;
      const double forHigh = mostColor > high ? segment->mostOpacity : segment->leastOpacity;
      low += forLow * (leastColor - low);
      high += forHigh * (mostColor - high);
    }
  }
  double bound = 0.0;
  for (std::size_t channel = 0; channel < 4; ++channel)
  {
    bound = std::max(bound, most[channel] - least[channel]);
  }
  return std::min(bound, 1.0);
}

}

std::vector<float> LevelBounds(const LevelBoundScene& scene)
{
  const LookBlocks blocks(scene);
  const glm::ivec2 pixels = scene.pixels;
  std::vector<float> bounds(std::size_t(pixels.x) * pixels.y);
  tbb::parallel_for(0, pixels.y,
    [&](int row)
    {
      for (int column = 0; column < pixels.x; ++column)
      {
        const Ray ray =
          scene.rays.At(2.0 * (column + 0.5) / pixels.x - 1.0, 2.0 * (row + 0.5) / pixels.y - 1.0);
        bounds[std::size_t(row) * pixels.x + column] =
          float(BoundOf(SegmentsOf(scene, blocks, ray)));
      }
    });
  return bounds;
}

}
