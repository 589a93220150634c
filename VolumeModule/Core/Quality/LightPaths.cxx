#include "Core/Quality/LightPaths.h"

#include "Core/Geometry/Box.h"
#include "Core/Geometry/CellWalk.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace varimarch
{

namespace
{

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

}
