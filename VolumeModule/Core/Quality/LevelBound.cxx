#include "Core/Quality/LevelBound.h"

#include "Core/Geometry/CellWalk.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>

namespace varimarch
{

namespace
{

/// The part of a ray in a block.
struct Segment
{
  std::size_t place; ///< The place of the block in BlockLevels.
  double mm;
  BlockLevel level;
  double light; ///< a bound of what the levels of other blocks change in its colours
  LookBetween look;
  double leastOpacity;
  double mostOpacity;
  double contribution; ///< a bound of what its level changes in the pixel
};

/// Composites of one channel behind a place of a ray.
struct Channel
{
  double least = 0.0; ///< a bound of both composites
  double most = 0.0;
  double apart = 0.0; ///< a bound of their difference
};

void Take(const LookBetween& look, Segment& segment)
{
  segment.look = look;
  segment.leastOpacity = -std::expm1(-segment.mm * double(look.least.a));
  segment.mostOpacity = -std::expm1(-segment.mm * double(look.most.a));
}

/// The bounds of what levels change in the light of blocks; empty without lights.
std::vector<double> LightOf(const LevelBoundScene& scene, const BlockLevels& levels)
{
  return scene.lights.empty() ? std::vector<double>()
                              : LightBounds(scene.looks, levels, scene.lights);
}

/// The bounds of what a ray meets in a block.
LookBetween LookOf(const LevelBoundScene& scene, const BlockLevels& levels, std::size_t place,
  const glm::ivec3& block)
{
  const BlockLevel level = levels.ofBlocks[place];
  LookBetween look = scene.looks.UpTo(IsCoarse(level) ? level : BlockLevel::Voxels, place);
  look.least.a = scene.endsEarlier && scene.looks.LevelEndsIn(block) ? 0.0f : look.least.a;
  return look;
}

/// The parts of the ray of a pixel that may be seen, front to back.
/// @param light  see LightOf
/// @param pixel  the place of its centre, [-1, 1]
std::vector<Segment> SegmentsOf(const LevelBoundScene& scene, const BlockLevels& levels,
  const std::vector<double>& light, const glm::dvec2& pixel)
{
  constexpr double MostDepth = 20.0;
  const Ray rayGrid = scene.rays.At(pixel.x, pixel.y);
  const Interval inside = Intersection(rayGrid, scene.boxGrid, scene.rays.BetweenPlanes(rayGrid));
  std::vector<Segment> segments;
  if (inside.IsEmpty())
  {
    return segments;
  }
  const double side = scene.looks.CellsPerSide();
  const double mmPerT = glm::length(scene.worldFromGrid * rayGrid.direction);
  double leastDepth = 0.0;
  WalkCells({ rayGrid.origin / side, rayGrid.direction / side }, inside,
    [&](const CellPart& part)
    {
      const std::size_t place = levels.PlaceOf(part.cell);
      const LookBetween look = LookOf(scene, levels, place, part.cell);
      const double mm = (part.t.exit - part.t.enter) * mmPerT;
      if (look.most.a > 0.0f)
      {
        segments.push_back({ place, mm, levels.ofBlocks[place], light.empty() ? 0.0 : light[place],
          {}, 0.0, 0.0, 0.0 });
        Take(look, segments.back());
        leastDepth += mm * double(look.least.a);
      }
      return leastDepth < MostDepth;
    });
  return segments;
}

/// The most that two materials between bounds can differ by over a segment.
double MostAdded(const Channel& behind, const Segment& segment, double leastColor, double mostColor)
{
  const LookBetween& look = segment.look;
  const double leastExtinction = double(look.least.a);
  const double fromComposite = std::max(
    mostColor - std::min(behind.least, leastColor), std::max(behind.most, mostColor) - leastColor);
  const double seenMm =
    segment.leastOpacity > 0.0 ? segment.leastOpacity / leastExtinction : segment.mm;
  return segment.mostOpacity * (mostColor - leastColor) +
    (double(look.most.a) - leastExtinction) * fromComposite * seenMm;
}

/// A channel of the looks along a ray.
struct ColorBetween
{
  double least;
  double most;
  double light; ///< the most that other light changes in it, where the look is the same
};

/// Goes on to what is in front of a segment.
/// @return a bound of what levels add to the difference
double Pass(Channel& channel, const Segment& segment, const ColorBetween& color)
{
  const double leastColor = color.least;
  const double mostColor = color.most;
  const double added = IsCoarse(segment.level) ? MostAdded(channel, segment, leastColor, mostColor)
                                               : segment.mostOpacity * color.light;
  const double forLeast = leastColor < channel.least ? segment.mostOpacity : segment.leastOpacity;
  const double forMost = mostColor > channel.most ? segment.mostOpacity : segment.leastOpacity;
  channel.least += forLeast * (leastColor - channel.least);
  channel.most += forMost * (mostColor - channel.most);
  const double width = channel.most - channel.least;
  channel.apart = std::min((1.0 - segment.leastOpacity) * channel.apart + added, width);
  return std::min(added, width);
}

/// The parts of a tolerance that may be errors of the looks of blocks, where there are lights, and
/// of the light that reaches them.
constexpr double LookShare = 0.5;
constexpr double LightShare = 0.4;

/// The differences that a bound of a ray counts.
enum class BoundOn
{
  Looks, ///< as if all light were that through voxels
  All,
};

/// The bound of a ray; finds the contributions of its segments.
double BoundOf(std::vector<Segment>& segments, BoundOn on)
{
  std::array<Channel, 4> channels;
  for (auto segment = segments.rbegin(); segment != segments.rend(); ++segment)
  {
    // The opacity is the composite of a colour of 1.
    segment->contribution = Pass(channels[3], *segment, { 1.0, 1.0, 0.0 });
    for (int i = 0; i < 3; ++i)
    {
      const ColorBetween color{ double(segment->look.least[i]), double(segment->look.most[i]),
        on == BoundOn::All ? segment->light : 0.0 };
      segment->contribution =
        std::max(segment->contribution, Pass(channels[std::size_t(i)], *segment, color));
    }
  }
  double transmittance = 1.0;
  for (Segment& segment : segments)
  {
    segment.contribution *= transmittance;
    transmittance *= 1.0 - segment.leastOpacity;
  }
  double bound = 0.0;
  for (const Channel& channel : channels)
  {
    bound = std::max(bound, channel.apart);
  }
  return std::min(bound, 1.0);
}

/// The findings of a round of refinement for blocks.
struct Findings
{
  /// A number for each block.
  using Numbers = std::vector<std::atomic<std::uint8_t>>;

  explicit Findings(const BlockLevels& levels)
    : levels(levels.ofBlocks.size())
    , lit(levels.ofBlocks.size())
  {
    for (std::size_t place = 0; place < levels.ofBlocks.size(); ++place)
    {
      this->levels[place] = std::uint8_t(levels.ofBlocks[place]);
    }
  }

  /// Asks for a level of a block that is at least as fine.
  void Ask(std::size_t place, BlockLevel level)
  {
    std::atomic<std::uint8_t>& asked = this->levels[place];
    std::uint8_t now = asked.load(std::memory_order_relaxed);
    while (now > std::uint8_t(level) &&
      !asked.compare_exchange_weak(now, std::uint8_t(level), std::memory_order_relaxed))
    {
    }
  }

  void MarkLit(std::size_t place) { this->lit[place].store(1, std::memory_order_relaxed); }

  Numbers levels; ///< the coarsest BlockLevel that serves
  Numbers lit;    ///< 1 for blocks of voxels whose light counts and has to be more exact
};

/// The contributions of the segments of a ray that may have a finer level, the largest first.
std::vector<std::pair<double, std::size_t>> ContributionsOf(const std::vector<Segment>& segments)
{
  std::vector<std::pair<double, std::size_t>> contributions;
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    if (IsCoarse(segments[i].level))
    {
      contributions.emplace_back(segments[i].contribution, i);
    }
  }
  std::sort(contributions.begin(), contributions.end(), std::greater<>());
  return contributions;
}

/// Takes the next finer levels for segments of a ray, those first that contribute most, until the
/// bound on their looks is at most the tolerance.
void RefineLooks(
  const BlockLooks& looks, double tolerance, std::vector<Segment>& segments, Findings& findings)
{
  // Rounding may make a bound a little more than the sum of the contributions, so that each turn
  // takes one segment at least.
  double bound = BoundOf(segments, BoundOn::Looks);
  auto contributions = ContributionsOf(segments);
  while (bound > tolerance && !contributions.empty())
  {
    double left = 0.0;
    for (const auto& contribution : contributions)
    {
      left += contribution.first;
    }
    const double goal = std::max(tolerance, 0.5 * left);
    auto next = contributions.begin();
    do
    {
      Segment& segment = segments[next->second];
      left -= next->first;
      segment.level = FinerThan(segment.level);
      Take(looks.UpTo(segment.level, segment.place), segment);
      findings.Ask(segment.place, segment.level);
      ++next;
    } while (next != contributions.end() && left > goal);
    bound = BoundOf(segments, BoundOn::Looks);
    contributions = ContributionsOf(segments);
  }
}

/// Finds what a ray needs so that its bound is at most the tolerance.
/// @return the bound, which may still be larger where light has to be more exact
double RefineRay(const LevelBoundScene& scene, double tolerance, std::vector<Segment>& segments,
  Findings& findings)
{
  const bool isLit = !scene.lights.empty();
  RefineLooks(scene.looks, isLit ? LookShare * tolerance : tolerance, segments, findings);
  const double bound = BoundOf(segments, BoundOn::All);
  const double least =
    (1.0 - LookShare - LightShare) * tolerance / double(std::max<std::size_t>(segments.size(), 1));
  for (const Segment& segment : segments)
  {
    if (isLit && bound > tolerance && !IsCoarse(segment.level) && segment.contribution > least)
    {
      findings.MarkLit(segment.place);
    }
  }
  return bound;
}

/// Calls visit(pixel, place of its centre, [-1, 1]) for the pixels of rows, on all cores.
template <class Visit>
void ForEachPixel(const glm::ivec2& pixels, int firstRow, int endRow, Visit visit)
{
  tbb::parallel_for(firstRow, endRow,
    [&](int row)
    {
      for (int column = 0; column < pixels.x; ++column)
      {
        visit(std::size_t(row) * std::size_t(pixels.x) + std::size_t(column),
          2.0 * (glm::dvec2(column, row) + 0.5) / glm::dvec2(pixels) - 1.0);
      }
    });
}

/// Takes the levels that were asked for.
/// @return the number of blocks whose level is new
std::size_t TakeAsked(const Findings& findings, BlockLevels& levels)
{
  std::size_t count = 0;
  for (std::size_t place = 0; place < levels.ofBlocks.size(); ++place)
  {
    const auto asked = BlockLevel(findings.levels[place].load());
    count += asked != levels.ofBlocks[place] ? 1 : 0;
    levels.ofBlocks[place] = asked;
  }
  return count;
}

/// Takes finer levels for what lies between marked blocks and lights. Where several blocks of a ray
/// share its tolerance, their light has to be more exact than LightShare alone says.
void RefineLightOf(const LevelBoundScene& scene, const RefinementRound& round,
  const Findings::Numbers& lit, BlockLevels& levels)
{
  constexpr double LeastShare = 1e-6;
  const std::vector<std::uint8_t> isLit(lit.begin(), lit.end());
  const bool anyIsLit = std::any_of(isLit.begin(), isLit.end(), [](int mark) { return mark != 0; });
  double share = LightShare;
  while (anyIsLit && share > LeastShare &&
    RefineLight(
      scene.looks, scene.lights, isLit, share * round.tolerance, round.mostBlocks, levels) == 0)
  {
    share *= 0.5;
  }
}

/// Finds the bounds of pixels anew whose bounds exceed a tolerance.
void UpdateBounds(const LevelBoundScene& scene, const BlockLevels& levels, double tolerance,
  std::vector<double>& bounds)
{
  // Looks of coarser levels allow for any light.
  const bool hasVoxels = std::find(levels.ofBlocks.begin(), levels.ofBlocks.end(),
                           BlockLevel::Voxels) != levels.ofBlocks.end();
  const std::vector<double> light =
    hasVoxels ? LightOf(scene, levels) : std::vector<double>(levels.ofBlocks.size());
  ForEachPixel(scene.pixels, 0, scene.pixels.y,
    [&](std::size_t pixel, const glm::dvec2& place)
    {
      if (bounds[pixel] > tolerance)
      {
        std::vector<Segment> segments = SegmentsOf(scene, levels, light, place);
        bounds[pixel] = BoundOf(segments, BoundOn::All);
      }
    });
}

}

std::vector<double> LevelBounds(const LevelBoundScene& scene, const BlockLevels& levels)
{
  std::vector<double> bounds(std::size_t(scene.pixels.x) * std::size_t(scene.pixels.y), 1.0);
  UpdateBounds(scene, levels, 0.0, bounds);
  return bounds;
}

// All rays of some rows see the levels that there were before, so that the result does not depend
// on their order. Finer levels never make a bound larger.
void Refine(const LevelBoundScene& scene, const RefinementRound& round, BlockLevels& levels,
  std::vector<double>& bounds)
{
  constexpr int RowsAtOnce = 16;
  Findings findings(levels);
  const std::vector<double> light = LightOf(scene, levels);
  std::size_t count = 0;
  for (int row = 0; row < scene.pixels.y && count < round.mostBlocks; row += RowsAtOnce)
  {
    ForEachPixel(scene.pixels, row, std::min(row + RowsAtOnce, scene.pixels.y),
      [&](std::size_t pixel, const glm::dvec2& place)
      {
        if (bounds[pixel] > round.tolerance)
        {
          std::vector<Segment> segments = SegmentsOf(scene, levels, light, place);
          bounds[pixel] = RefineRay(scene, round.tolerance, segments, findings);
        }
      });
    count += TakeAsked(findings, levels);
  }
  if (!scene.lights.empty() && count < round.mostBlocks)
  {
    RefineLightOf(scene, { round.tolerance, round.mostBlocks - count }, findings.lit, levels);
    UpdateBounds(scene, levels, round.tolerance, bounds);
  }
}

}
