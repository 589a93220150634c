#include "Core/Fields/ExtremeBricks.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

constexpr int StepCount = 65536;

glm::dvec4 Premultiplied(const glm::dvec4& optical, double unitDistanceMm)
{
  const double opacity = -std::expm1(-optical.a * unitDistanceMm);
  return { opacity * optical.r, opacity * optical.g, opacity * optical.b, opacity };
}

// Accumulated change of colour and opacity from the table's first entry to each entry. The
// difference of this sum between two entries bounds the difference of their colours in every
// channel.
std::vector<double> ChangeUpTo(const ExtremeLook& look)
{
  std::vector<double> changes = { 0.0 };
  glm::dvec4 before = Premultiplied(look.table.entries.front(), look.opacityUnitDistanceMm);
  for (std::size_t i = 1; i < look.table.entries.size(); ++i)
  {
    const glm::dvec4 here = Premultiplied(look.table.entries[i], look.opacityUnitDistanceMm);
    const glm::dvec4 change = glm::abs(here - before);
    changes.push_back(changes.back() + std::max({ change.r, change.g, change.b, change.a }));
    before = here;
  }
  return changes;
}

// Bounds of the accumulated change at a step of the brick ranges.
class ChangeOfSteps
{
public:
  ChangeOfSteps(const BrickRanges& ranges, const ExtremeLook& look)
    : changes(ChangeUpTo(look))
    , entryOfStep(IndexOf(
        look.table, double(this->changes.size()) - 1.0, ranges.ValuePerStep(), ranges.FirstValue()))
  {
  }

  double Least(int step) const { return this->At(std::floor(this->EntryOf(step))); }
  double Most(int step) const { return this->At(std::ceil(this->EntryOf(step))); }

private:
  double EntryOf(int step) const { return this->entryOfStep.bias + step * this->entryOfStep.scale; }

  double At(double entry) const
  {
    return this->changes[std::size_t(std::clamp(entry, 0.0, double(this->changes.size()) - 1.0))];
  }

  std::vector<double> changes;
  IndexInTable entryOfStep;
};

// For each step up to the last, the least step whose colour differs by at most the tolerance.
std::vector<std::uint16_t> LeastAlike(const ChangeOfSteps& change, double tolerance, int last)
{
  std::vector<std::uint16_t> alike(std::size_t(last) + 1);
  int least = 0;
  for (int step = 0; step <= last; ++step)
  {
    while (least < step && change.Most(step) - change.Least(least) > tolerance)
    {
      ++least;
    }
    alike[step] = std::uint16_t(least);
  }
  return alike;
}

// The greatest one. It is a step that values have: a ray without a value yet, which stands beyond
// all values, enters every brick.
std::vector<std::uint16_t> GreatestAlike(const ChangeOfSteps& change, double tolerance, int last)
{
  std::vector<std::uint16_t> alike(std::size_t(last) + 1);
  int greatest = last;
  for (int step = last; step >= 0; --step)
  {
    while (greatest > step && change.Most(greatest) - change.Least(step) > tolerance)
    {
      --greatest;
    }
    alike[step] = std::uint16_t(greatest);
  }
  return alike;
}

}

std::vector<std::uint16_t> BuildExtremeBricks(
  const BrickRanges& ranges, const ExtremeLook& look, bool largest)
{
  const ChangeOfSteps change(ranges, look);
  const std::vector<std::uint16_t> alike = largest
    ? LeastAlike(change, look.tolerance, ranges.LastStep())
    : GreatestAlike(change, look.tolerance, ranges.LastStep());
  const glm::ivec3 count = ranges.BrickCount();
  std::vector<std::uint16_t> extremes(std::size_t(count.x) * count.y * count.z);
  for (std::size_t i = 0; i < extremes.size(); ++i)
  {
    const BrickRanges::Steps steps = ranges[i];
    const int any = largest ? StepCount - 1 : 0;
    extremes[i] =
      steps.IsFinite() ? alike[largest ? steps.largest : steps.smallest] : std::uint16_t(any);
  }
  return extremes;
}

ExtremeBlocks JoinExtremeBricks(
  const std::vector<std::uint16_t>& bricks, glm::ivec3 brickCount, bool largest)
{
  constexpr int Side = ExtremeBlocks::BricksPerSide;
  ExtremeBlocks blocks;
  blocks.count = (brickCount + Side - 1) / Side;
  const std::uint16_t least = largest ? 0 : StepCount - 1;
  blocks.steps.assign(std::size_t(blocks.count.x) * blocks.count.y * blocks.count.z, least);
  const std::uint16_t* brick = bricks.data();
  for (int z = 0; z < brickCount.z; ++z)
  {
    for (int y = 0; y < brickCount.y; ++y)
    {
      std::uint16_t* const row =
        &blocks.steps[(std::size_t(z / Side) * blocks.count.y + y / Side) * blocks.count.x];
      for (int x = 0; x < brickCount.x; ++x, ++brick)
      {
        std::uint16_t& step = row[x / Side];
        step = largest ? std::max(step, *brick) : std::min(step, *brick);
      }
    }
  }
  return blocks;
}

}
