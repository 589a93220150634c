#include "Core/Quality/LightBound.h"

#include "Core/Geometry/Box.h"
#include "Core/Geometry/CellWalk.h"
#include "Core/Quality/LightSlabs.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vector_relational.hpp>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <mutex>
#include <utility>
#include <vector>

namespace varimarch
{
namespace
{

/// The matter between single blocks and a lamp near the volume, or within the reach of light from a
/// direction. Rays from all places of a block are at most half a block away from the ray from its
/// middle, along each axis, so that they pass the eight blocks around the corner next to that ray.
class LightPaths
{
public:
  /// @param matters  that of each block; kept by reference, as the levels are
  LightPaths(const BlockLevels& levels, const std::vector<Matter>& matters, const LevelLight& light)
    : levels(levels)
    , matters(matters)
    , light(light)
  {
  }

  /// A bound of what levels change in the part of the light that reaches places of a block.
  double ChangeAt(const glm::ivec3& block) const;

  /// Adds the blocks around the part of the way that changes most, until the others change at most
  /// half of the tolerance.
  void AddWorst(const glm::ivec3& block, double tolerance, std::vector<std::size_t>& places) const;

private:
  /// A part of the way next to a corner.
  struct Part
  {
    glm::ivec3 corner; ///< number of the block above it along each axis
    double change;     ///< the most that it changes in the light
  };

  /// Calls visit(Part) for all parts that change anything, from the block on.
  /// @return the part of the light that comes through them
  template <class Visit>
  double ForEachPart(const glm::ivec3& block, Visit visit) const;
  /// Calls visit(place) for the blocks around a corner, as far as they are in the volume.
  template <class Visit>
  void ForEachAround(const glm::ivec3& corner, Visit visit) const;
  Matter MatterAround(const glm::ivec3& corner) const;

  const BlockLevels& levels;
  const std::vector<Matter>& matters;
  const LevelLight& light;
};

// Paths end where no more than this part of the light comes.
constexpr double Nothing = 1e-6;

/// The rays from all places of a block.
struct PathsOfBlock
{
  Ray ray;        ///< the one from its middle, in blocks, at t from 0 to 1
  double leastMm; ///< length of the shortest ray
  double mostMm;  ///< length of the longest ray
};

PathsOfBlock PathsOf(const LevelLight& light, const glm::ivec3& block, double side)
{
  const glm::dvec3 middle = glm::dvec3(block) + 0.5;
  if (!light.lamp)
  {
    return { { middle, light.reachMm / side * light.towardsGrid }, light.reachMm, light.reachMm };
  }
  const glm::dvec3 way = light.lamp->placeGrid / side - middle;
  const double mm = glm::length(light.lamp->worldFromGrid * (side * way));
  // A corner of the block is this far from its middle at most.
  double cornerMm = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    cornerMm += 0.5 * side * glm::length(light.lamp->worldFromGrid[axis]);
  }
  return { { middle, way }, std::max(mm - cornerMm, 0.0), mm + cornerMm };
}

template <class Visit>
void LightPaths::ForEachAround(const glm::ivec3& corner, Visit visit) const
{
  for (int i = 0; i < 8; ++i)
  {
    const glm::ivec3 block = corner - glm::ivec3(i & 1, i >> 1 & 1, i >> 2);
    if (glm::all(glm::greaterThanEqual(block, glm::ivec3(0))) &&
      glm::all(glm::lessThan(block, this->levels.count)))
    {
      visit(this->levels.PlaceOf(block));
    }
  }
}

// The outermost blocks may be cut, so that rays through them need not meet anything.
Matter LightPaths::MatterAround(const glm::ivec3& corner) const
{
  const bool isInner = glm::all(glm::greaterThan(corner, glm::ivec3(1))) &&
    glm::all(glm::lessThan(corner, this->levels.count - 1));
  Matter all{ isInner ? std::numeric_limits<float>::max() : 0.0f, 0.0f };
  this->ForEachAround(corner,
    [&](std::size_t place)
    {
      all.least = std::min(all.least, this->matters[place].least);
      all.change = std::max(all.change, this->matters[place].change);
    });
  return all;
}

template <class Visit>
double LightPaths::ForEachPart(const glm::ivec3& block, Visit visit) const
{
  const PathsOfBlock paths = PathsOf(this->light, block, double(this->levels.side));
  // Corners are in the middle of cells that are shifted by half a block.
  const Ray shifted{ paths.ray.origin + 0.5, paths.ray.direction };
  const Box inside{ glm::dvec3(0.0), glm::dvec3(this->levels.count + 1) };
  double transmitted = 1.0;
  WalkCells(shifted, Intersection(shifted, inside, { 0.0, 1.0 }),
    [&](const CellPart& part)
    {
      const double t = part.t.exit - part.t.enter;
      const Matter matter = this->MatterAround(part.cell);
      const double change = transmitted * -std::expm1(-t * paths.mostMm * double(matter.change));
      if (change > 0.0)
      {
        visit(Part{ part.cell, change });
      }
      transmitted *= std::exp(-t * paths.leastMm * double(matter.least));
      return transmitted > Nothing;
    });
  return transmitted;
}

double LightPaths::ChangeAt(const glm::ivec3& block) const
{
  double change = 0.0;
  const double transmitted =
    this->ForEachPart(block, [&](const Part& part) { change += part.change; });
  const double behind = transmitted > Nothing ? 0.0 : Nothing;
  return std::min(change + behind, 1.0);
}

void LightPaths::AddWorst(
  const glm::ivec3& block, double tolerance, std::vector<std::size_t>& places) const
{
  std::vector<Part> parts;
  double left = 0.0;
  this->ForEachPart(block,
    [&](const Part& part)
    {
      parts.push_back(part);
      left += part.change;
    });
  std::sort(parts.begin(), parts.end(),
    [](const Part& one, const Part& other) { return one.change > other.change; });
  for (auto part = parts.begin(); part != parts.end() && left > 0.5 * tolerance; ++part)
  {
    left -= part->change;
    this->ForEachAround(part->corner, [&](std::size_t place) { places.push_back(place); });
  }
}

Matter MatterOf(const BlockLooks& looks, const BlockLevels& levels, std::size_t place)
{
  const BlockLevel level = levels.ofBlocks[place];
  if (level == BlockLevel::Nothing)
  {
    return {};
  }
  const LookBetween look = looks.UpTo(level, place);
  return { look.least.a, IsCoarse(level) ? look.most.a - look.least.a : 0.0f };
}

/// The matter of all blocks.
std::vector<Matter> MattersOf(const BlockLooks& looks, const BlockLevels& levels)
{
  std::vector<Matter> matters(levels.ofBlocks.size());
  tbb::parallel_for(std::size_t(0), matters.size(),
    [&](std::size_t place) { matters[place] = MatterOf(looks, levels, place); });
  return matters;
}

/// Takes a finer level for a block, if that changes anything.
bool TakesFiner(
  const BlockLooks& looks, BlockLevels& levels, std::vector<Matter>& matters, std::size_t place)
{
  const bool changes = matters[place].change > 0.0f;
  if (changes)
  {
    levels.ofBlocks[place] = FinerThan(levels.ofBlocks[place]);
    matters[place] = MatterOf(looks, levels, place);
  }
  return changes;
}

double Changed(double mm, const Matter& matter)
{
  return -std::expm1(-mm * double(matter.change));
}

double Behind(double mm, const Matter& matter, double within)
{
  return within * std::exp(-mm * double(matter.least));
}

/// The differences of transmittances along the columns of a light, slab by slab from the light on.
class ColumnDifferences
{
public:
  explicit ColumnDifferences(const LightSlabs& slabs)
    : slabs(slabs)
    , behind(slabs.NumberCount())
    , within(slabs.NumberCount())
  {
  }

  /// Goes to the next slab.
  void Enter(int slab)
  {
    const Blocks columns = this->slabs.ColumnsIn(slab);
    const Blocks wasIn = this->slabs.ColumnsIn(std::min(slab + 1, this->slabs.Count() - 1));
    tbb::parallel_for(columns.first.y, columns.last.y + 1,
      [&](int row)
      {
        for (int i = columns.first.x; i <= columns.last.x; ++i)
        {
          const glm::ivec2 column(i, row);
          const std::size_t number = this->slabs.NumberOf(column);
          const double before = wasIn.Contain(column) ? this->behind[number] : 0.0;
          const Matter matter = this->slabs.MatterIn(slab, column);
          this->within[number] = std::min(before + Changed(this->slabs.Mm(), matter), 1.0);
          this->behind[number] = Behind(this->slabs.Mm(), matter, this->within[number]);
        }
      });
  }

  /// The largest difference at places of a block in the slab.
  double LargestIn(int slab, const glm::ivec2& block) const
  {
    const Blocks columns = this->slabs.ColumnsOf(slab, block);
    double most = 0.0;
    for (int y = columns.first.y; y <= columns.last.y; ++y)
    {
      for (int x = columns.first.x; x <= columns.last.x; ++x)
      {
        most = std::max(most, this->within[this->slabs.NumberOf({ x, y })]);
      }
    }
    return most;
  }

private:
  const LightSlabs& slabs;
  std::vector<double> behind; ///< behind the slabs so far
  std::vector<double> within; ///< in the present slab
};

/// Adds the bounds of one light to those of all blocks.
void AddBounds(const LightSlabs& slabs, double strength, std::vector<double>& bounds)
{
  ColumnDifferences differences(slabs);
  const glm::ivec2 across = slabs.Across();
  for (int slab = slabs.Count() - 1; slab >= 0; --slab)
  {
    differences.Enter(slab);
    for (int y = 0; y < across.y; ++y)
    {
      for (int x = 0; x < across.x; ++x)
      {
        bounds[slabs.PlaceOf(slab, { x, y })] += strength * differences.LargestIn(slab, { x, y });
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

/// Takes finer levels for blocks between other blocks and a light.
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
    const SlabRange range = this->slabs.SlabsOf(column);
    double behind = 0.0;
    for (int slab = range.last; slab >= range.first; --slab)
    {
      const Matter matter = this->slabs.MatterIn(slab, column);
      const double within = behind + Changed(this->slabs.Mm(), matter);
      bool counts = false;
      this->slabs.ForEach(
        slab, column, [&](std::size_t place) { counts = counts || isLit[place] != 0; });
      if (counts && within > tolerance && this->TakeBehind(slab, column, tolerance))
      {
        behind = 0.0;
        slab = range.last + 1; // the column begins anew
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
    for (int slab = firstSlab; slab <= this->slabs.SlabsOf(column).last; ++slab)
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

  // Takes finer levels for what changes the light of a slab most; false if there are none.
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
      this->slabs.ForEach(next->slab, column,
        [&](std::size_t place)
        { this->taken += TakesFiner(this->looks, this->levels, this->matters, place) ? 1 : 0; });
    }
    return this->taken > before;
  }

  const BlockLooks& looks;
  const LightSlabs& slabs;
  BlockLevels& levels;
  std::vector<Matter>& matters;
  std::size_t taken = 0;
};

/// The blocks that are drawn by voxels, and those around them: 1, and 0 for others.
std::vector<std::uint8_t> VoxelsAndAround(const BlockLevels& levels)
{
  std::vector<std::uint8_t> marks(levels.ofBlocks.size());
  std::transform(levels.ofBlocks.begin(), levels.ofBlocks.end(), marks.begin(),
    [](BlockLevel level) { return std::uint8_t(level == BlockLevel::Voxels ? 1 : 0); });
  return LargestAround(levels, std::move(marks));
}

/// Calls visit(block, place) for blocks that are marked, on all cores.
template <class Visit>
void ForEachMarked(const BlockLevels& levels, const std::vector<std::uint8_t>& marks, Visit visit)
{
  tbb::parallel_for(0, levels.count.y * levels.count.z,
    [&](int row)
    {
      for (int x = 0; x < levels.count.x; ++x)
      {
        const glm::ivec3 block(x, row % levels.count.y, row / levels.count.y);
        const std::size_t place = levels.PlaceOf(block);
        if (marks[place] != 0)
        {
          visit(block, place);
        }
      }
    });
}

/// Takes finer levels for blocks that are between marked ones and a light without columns.
class PathRefinement
{
public:
  PathRefinement(const BlockLooks& looks, BlockLevels& levels, std::vector<Matter>& matters)
    : looks(looks)
    , levels(levels)
    , matters(matters)
  {
  }

  /// @return the number of blocks with a finer level
  std::size_t Refine(
    const LevelLight& light, const std::vector<std::uint8_t>& marks, double tolerance)
  {
    const LightPaths paths(this->levels, this->matters, light);
    std::mutex mutex;
    std::vector<std::size_t> found;
    ForEachMarked(this->levels, marks,
      [&](const glm::ivec3& block, std::size_t)
      {
        std::vector<std::size_t> places;
        if (paths.ChangeAt(block) > tolerance)
        {
          paths.AddWorst(block, tolerance, places);
        }
        const std::lock_guard<std::mutex> lock(mutex);
        found.insert(found.end(), places.begin(), places.end());
      });
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return std::size_t(std::count_if(found.begin(), found.end(),
      [&](std::size_t place)
      { return TakesFiner(this->looks, this->levels, this->matters, place); }));
  }

private:
  const BlockLooks& looks;
  BlockLevels& levels;
  std::vector<Matter>& matters;
};

}

std::vector<double> LightBounds(
  const BlockLooks& looks, const BlockLevels& levels, const std::vector<LevelLight>& lights)
{
  const std::vector<Matter> matters = MattersOf(looks, levels);
  std::vector<double> bounds(levels.ofBlocks.size());
  const std::vector<std::uint8_t> marks = VoxelsAndAround(levels);
  for (const LevelLight& light : lights)
  {
    if (light.IsFromInfinity())
    {
      AddBounds(LightSlabs(looks.CellsPerSide(), levels, matters, light.towardsGrid),
        light.strength, bounds);
      continue;
    }
    const LightPaths paths(levels, matters, light);
    ForEachMarked(levels, marks,
      [&](const glm::ivec3& block, std::size_t place)
      { bounds[place] += light.strength * paths.ChangeAt(block); });
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
  double allStrengths = 0.0;
  for (const LevelLight& light : lights)
  {
    allStrengths += light.strength;
  }
  // Each light may be wrong by the same part of what it makes of a colour.
  const double share = tolerance / allStrengths;
  for (const LevelLight& light : lights)
  {
    if (!light.IsFromInfinity())
    {
      taken += taken < mostBlocks
        ? PathRefinement(looks, levels, matters).Refine(light, counts, share)
        : 0;
      continue;
    }
    const LightSlabs slabs(looks.CellsPerSide(), levels, matters, light.towardsGrid);
    ColumnRefinement refinement(looks, slabs, levels, matters);
    const Blocks columns = slabs.AllColumns();
    for (int y = columns.first.y; y <= columns.last.y; ++y)
    {
      for (int x = columns.first.x; x <= columns.last.x && taken + refinement.Taken() < mostBlocks;
           ++x)
      {
        refinement.Refine({ x, y }, counts, share);
      }
    }
    taken += refinement.Taken();
  }
  return taken;
}

}
