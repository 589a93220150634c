#include "Core/Quality/LightBound.h"

#include "Core/Quality/LightSlabs.h"

#include <glm/common.hpp>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace varimarch
{

namespace
{

Matter MatterOf(const BlockLooks& looks, const BlockLevels& levels, std::size_t place)
{
  switch (levels.ofBlocks[place])
  {
    case BlockLevel::Coarse:
    {
      const LookBetween look = looks.OfBoth(place);
      return { look.least.a, look.most.a - look.least.a };
    }
    case BlockLevel::Voxels:
      return { looks.OfVoxels(place).least.a, 0.0f };
    case BlockLevel::Nothing:
      break;
  }
  return {};
}

/// The matter of all blocks.
std::vector<Matter> MattersOf(const BlockLooks& looks, const BlockLevels& levels)
{
  std::vector<Matter> matters(levels.ofBlocks.size());
  tbb::parallel_for(std::size_t(0), matters.size(),
    [&](std::size_t place) { matters[place] = MatterOf(looks, levels, place); });
  return matters;
}

double Changed(double mm, const Matter& matter)
{
  return -std::expm1(-mm * double(matter.change));
}

double Behind(double mm, const Matter& matter, double within)
{
  return within * std::exp(-mm * double(matter.least));
}

/// Adds the bounds of one light to those of all blocks.
void AddBounds(const LightSlabs& slabs, double strength, std::vector<double>& bounds)
{
  std::vector<double> behind(slabs.ColumnCount()); // the difference behind the slabs so far
  std::vector<double> within(slabs.ColumnCount()); // that in the present slab
  for (int slab = slabs.Count() - 1; slab >= 0; --slab)
  {
    tbb::parallel_for(0, slabs.Rows(),
      [&](int row)
      {
        for (int i = 0; i < slabs.ColumnsPerRow(); ++i)
        {
          const glm::ivec2 column = slabs.ColumnAt(row, i);
          const std::size_t index = slabs.IndexOf(column);
          const Matter matter = slabs.MatterIn(slab, column);
          within[index] = std::min(behind[index] + Changed(slabs.Mm(), matter), 1.0);
          behind[index] = Behind(slabs.Mm(), matter, within[index]);
        }
      });
    const glm::ivec2 across = slabs.Across();
    for (int y = 0; y < across.y; ++y)
    {
      for (int x = 0; x < across.x; ++x)
      {
        const Blocks columns = slabs.ColumnsOf(slab, { x, y });
        double most = 0.0;
        for (int v = columns.first.y; v <= columns.last.y; ++v)
        {
          for (int u = columns.first.x; u <= columns.last.x; ++u)
          {
            most = std::max(most, within[slabs.IndexOf({ u, v })]);
          }
        }
        bounds[slabs.PlaceOf(slab, { x, y })] += strength * most;
      }
    }
  }
}

/// Each number becomes the largest of the blocks around its block.
template <class Number>
std::vector<Number> LargestAround(const BlockLevels& levels, std::vector<Number> numbers)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    std::vector<Number> larger(numbers.size());
    glm::ivec3 block;
    for (block.z = 0; block.z < levels.count.z; ++block.z)
    {
      for (block.y = 0; block.y < levels.count.y; ++block.y)
      {
        for (block.x = 0; block.x < levels.count.x; ++block.x)
        {
          glm::ivec3 step(0);
          step[axis] = 1;
          const std::size_t place = levels.PlaceOf(block);
          larger[place] = std::max({ numbers[levels.PlaceOf(block - step)], numbers[place],
            numbers[levels.PlaceOf(block + step)] });
        }
      }
    }
    numbers = std::move(larger);
  }
  return numbers;
}

/// Takes voxels for blocks between other blocks and a light.
class ColumnRefinement
{
public:
  ColumnRefinement(const BlockLooks& looks, const LightSlabs& slabs, BlockLevels& levels,
    std::vector<Matter>& matters)
    : looks(looks)
    , slabs(slabs)
    , levels(levels)
    , matters(matters)
  {
  }

  std::size_t Taken() const { return this->taken; }

  /// Refines a column until the light of its blocks that count changes by at most the tolerance.
  /// @param isLit  not 0 for blocks that count
  void Refine(const glm::ivec2& column, const std::vector<std::uint8_t>& isLit, double tolerance)
  {
    double behind = 0.0;
    for (int slab = this->slabs.Count() - 1; slab >= 0; --slab)
    {
      const Matter matter = this->slabs.MatterIn(slab, column);
      const double within = behind + Changed(this->slabs.Mm(), matter);
      bool counts = false;
      this->slabs.ForEach(
        slab, column, [&](std::size_t place) { counts = counts || isLit[place] != 0; });
      if (counts && within > tolerance && this->TakeBehind(slab, column, tolerance))
      {
        behind = 0.0;
        slab = this->slabs.Count(); // the column begins anew
        continue;
      }
      behind = Behind(this->slabs.Mm(), matter, within);
    }
  }

private:
  /// The most that a slab changes in the light of a place.
  struct Change
  {
    double size;
    int slab;
  };

  // The changes of all slabs between a place and the light.
  std::vector<Change> ChangesFrom(int firstSlab, const glm::ivec2& column) const
  {
    std::vector<Change> changes;
    double transmitted = 1.0;
    for (int slab = firstSlab; slab < this->slabs.Count(); ++slab)
    {
      const Matter matter = this->slabs.MatterIn(slab, column);
      // A place in the first slab need not have matter in front of it.
      transmitted = slab == firstSlab ? 1.0 : Behind(this->slabs.Mm(), matter, transmitted);
      changes.push_back({ transmitted * Changed(this->slabs.Mm(), matter), slab });
    }
    std::sort(changes.begin(), changes.end(),
      [](const Change& one, const Change& other) { return one.size > other.size; });
    return changes;
  }

  // Takes voxels for what changes the light of a slab most; false if there is nothing to take.
  bool TakeBehind(int slab, const glm::ivec2& column, double tolerance)
  {
    const std::vector<Change> changes = this->ChangesFrom(slab, column);
    double left = 0.0;
    for (const Change& change : changes)
    {
      left += change.size;
    }
    const std::size_t before = this->taken;
    for (auto next = changes.begin(); next != changes.end() && left > 0.5 * tolerance; ++next)
    {
      left -= next->size;
      this->slabs.ForEach(next->slab, column, [&](std::size_t place) { this->Take(place); });
    }
    return this->taken > before;
  }

  void Take(std::size_t place)
  {
    if (this->matters[place].change > 0.0f)
    {
      this->levels.ofBlocks[place] = BlockLevel::Voxels;
      this->matters[place] = MatterOf(this->looks, this->levels, place);
      ++this->taken;
    }
  }

  const BlockLooks& looks;
  const LightSlabs& slabs;
  BlockLevels& levels;
  std::vector<Matter>& matters;
  std::size_t taken = 0;
};

}

std::vector<double> LightBounds(
  const BlockLooks& looks, const BlockLevels& levels, const std::vector<LevelLight>& lights)
{
  const std::vector<Matter> matters = MattersOf(looks, levels);
  std::vector<double> bounds(levels.ofBlocks.size());
  for (const LevelLight& light : lights)
  {
    AddBounds(
      LightSlabs(looks.CellsPerSide(), levels, matters, light.towardsGrid), light.strength, bounds);
  }
  return LargestAround(levels, std::move(bounds));
}

std::size_t RefineLight(const BlockLooks& looks, const std::vector<LevelLight>& lights,
  const std::vector<std::uint8_t>& isLit, double tolerance, std::size_t mostBlocks,
  BlockLevels& levels)
{
  const std::vector<std::uint8_t> counts = LargestAround(levels, isLit);
  std::vector<Matter> matters = MattersOf(looks, levels);
  std::size_t taken = 0;
  for (const LevelLight& light : lights)
  {
    const LightSlabs slabs(looks.CellsPerSide(), levels, matters, light.towardsGrid);
    ColumnRefinement refinement(looks, slabs, levels, matters);
    const double share = tolerance / (light.strength * double(lights.size()));
    for (int row = 0; row < slabs.Rows(); ++row)
    {
      for (int i = 0; i < slabs.ColumnsPerRow() && taken + refinement.Taken() < mostBlocks; ++i)
      {
        refinement.Refine(slabs.ColumnAt(row, i), counts, share);
      }
    }
    taken += refinement.Taken();
  }
  return taken;
}

}
