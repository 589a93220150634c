#include "Core/Fields/OpticalField.h"

#include "Core/Fields/ChebyshevDistance.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <functional>
#include <iterator>
#include <numeric>

namespace varimarch
{

namespace
{

// Intervals of table entries of constant look. Every part of such an interval has a constant look
// too, so one number per first entry suffices: the last entry of the longest interval.
struct AlikeIntervals
{
  std::vector<int> invisibleUntil;   ///< first - 1 if the entry itself is visible
  std::vector<int> homogeneousUntil; ///< at least the first entry
};

// Smallest or largest value of one component of the entries in a window whose ends only move
// forwards. Keeps the entries that may still become the extreme, best first.
template <class Better>
class SlidingExtreme
{
public:
  explicit SlidingExtreme(int component)
    : component(component)
  {
  }

  void Add(const std::vector<glm::vec4>& entries, int entry)
  {
    const float value = entries[entry][this->component];
    while (!this->candidates.empty() && !Better()(this->candidates.back().second, value))
    {
      this->candidates.pop_back();
    }
    this->candidates.emplace_back(entry, value);
  }

  void DropBefore(int entry)
  {
    while (!this->candidates.empty() && this->candidates.front().first < entry)
    {
      this->candidates.pop_front();
    }
  }

  float Value() const { return this->candidates.front().second; }

private:
  int component;
  std::deque<std::pair<int, float>> candidates;
};

struct SlidingRange
{
  explicit SlidingRange(int component)
    : smallest(component)
    , largest(component)
  {
  }

  void Add(const std::vector<glm::vec4>& entries, int entry)
  {
    this->smallest.Add(entries, entry);
    this->largest.Add(entries, entry);
  }

  void DropBefore(int entry)
  {
    this->smallest.DropBefore(entry);
    this->largest.DropBefore(entry);
  }

  double Extent() const { return double(this->largest.Value()) - this->smallest.Value(); }

  SlidingExtreme<std::less<float>> smallest;
  SlidingExtreme<std::greater<float>> largest;
};

bool IsHomogeneous(const std::vector<SlidingRange>& ranges, const OpticalTolerance& tolerance)
{
  const SlidingRange& extinction = ranges[3];
  const double allowed = std::max(tolerance.relativeExtinction * extinction.smallest.Value(),
    tolerance.opticalDepth / tolerance.longestRayMm);
  return extinction.Extent() <= allowed &&
    std::all_of(ranges.begin(), ranges.begin() + 3,
      [&](const SlidingRange& color) { return color.Extent() <= tolerance.color; });
}

std::vector<int> HomogeneousUntil(
  const std::vector<glm::vec4>& entries, const OpticalTolerance& tolerance)
{
  const int count = int(entries.size());
  std::vector<int> until(count);
  std::vector<SlidingRange> ranges = { SlidingRange(0), SlidingRange(1), SlidingRange(2),
    SlidingRange(3) };
  int next = 0;
  for (int first = 0; first < count; ++first)
  {
    for (SlidingRange& range : ranges)
    {
      range.DropBefore(first);
    }
    // The window holds first ... next - 1; it grows until an entry breaks the rule.
    while (next < count && (next <= first || IsHomogeneous(ranges, tolerance)))
    {
      for (SlidingRange& range : ranges)
      {
        range.Add(entries, next);
      }
      ++next;
    }
    until[first] = IsHomogeneous(ranges, tolerance) ? next - 1 : next - 2;
  }
  return until;
}

std::vector<int> InvisibleUntil(const std::vector<glm::vec4>& entries)
{
  std::vector<int> until(entries.size());
  int last = int(entries.size()) - 1;
  for (int first = last; first >= 0; --first)
  {
    last = entries[first].a > 0.0f ? first - 1 : last;
    until[first] = last;
  }
  return until;
}

// Consequences of a range step for the bricks whose range begins or ends with it. Computed once
// per step, because there are a thousand bricks per step.
struct StepLook
{
  int invisibleUntil;   ///< last entry up to which a brick that begins here is invisible
  int homogeneousUntil; ///< last entry up to which a brick that begins here is homogeneous
  int lastEntry;        ///< last table entry that a brick whose range ends here uses
};

class BrickClassifier
{
public:
  BrickClassifier(
    const BrickRanges& ranges, const OpticalTable& table, const OpticalTolerance& tolerance)
    : looks(std::size_t(ranges.LastStep()) + 1)
  {
    const AlikeIntervals alike{ InvisibleUntil(table.entries),
      HomogeneousUntil(table.entries, tolerance) };
    const double lastEntry = double(table.entries.size()) - 1.0;
    const IndexInTable entryOfStep =
      IndexOf(table, lastEntry, ranges.ValuePerStep(), ranges.FirstValue());
    for (std::size_t step = 0; step < this->looks.size(); ++step)
    {
      // The product's rounding must not add a neighbour to a value that lies exactly on an entry.
      constexpr double rounding = 1e-6;
      const double entry = entryOfStep.bias + double(step) * entryOfStep.scale;
      const int first = int(std::clamp(std::floor(entry + rounding), 0.0, lastEntry));
      const int last = int(std::clamp(std::ceil(entry - rounding), 0.0, lastEntry));
      this->looks[step] = { alike.invisibleUntil[first], alike.homogeneousUntil[first], last };
    }
  }

  std::uint8_t ClassOf(BrickRanges::Steps steps) const
  {
    if (!steps.IsFinite())
    {
      return OpticalField::Structured;
    }
    const StepLook& first = this->looks[steps.smallest];
    const int lastEntry = this->looks[steps.largest].lastEntry;
    if (lastEntry <= first.invisibleUntil)
    {
      return OpticalField::Invisible;
    }
    return lastEntry <= first.homogeneousUntil ? OpticalField::Homogeneous
                                               : OpticalField::Structured;
  }

private:
  std::vector<StepLook> looks; ///< one per step
};

// A brick has the least uniform class of the channels that its rows show.
class ChannelsClassifier
{
public:
  ChannelsClassifier(const std::vector<OpticalChannel>& channels, const BrickRows& rows,
    const OpticalTolerance& tolerance)
    : channels(channels)
    , rows(rows)
  {
    for (const OpticalChannel& channel : channels)
    {
      this->classifiers.emplace_back(channel.ranges, channel.table, tolerance);
    }
    if (!rows.AreKnown())
    {
      this->channelsOfSet.emplace_back(channels.size());
      std::iota(this->channelsOfSet[0].begin(), this->channelsOfSet[0].end(), 0);
    }
    for (const std::vector<std::uint16_t>& set : rows.Sets())
    {
      this->channelsOfSet.push_back(this->ChannelsOf(set));
    }
  }

  std::uint8_t ClassOf(std::size_t brick) const
  {
    std::uint8_t least = OpticalField::Invisible;
    for (const std::size_t i :
      this->channelsOfSet[this->rows.AreKnown() ? this->rows.SetOf(brick) : 0])
    {
      least = std::min(least, this->classifiers[i].ClassOf(this->channels[i].ranges[brick]));
    }
    return least;
  }

private:
  std::vector<std::size_t> ChannelsOf(const std::vector<std::uint16_t>& set) const
  {
    std::vector<std::size_t> shown;
    for (std::size_t i = 0; i < this->channels.size(); ++i)
    {
      if (std::binary_search(set.begin(), set.end(), this->channels[i].row))
      {
        shown.push_back(i);
      }
    }
    return shown;
  }

  const std::vector<OpticalChannel>& channels;
  const BrickRows& rows;
  std::vector<BrickClassifier> classifiers;
  std::vector<std::vector<std::size_t>> channelsOfSet; ///< the channels that each set of rows shows
};

// Builds a field from the class of each brick, classOf(index).
template <class ClassOf>
OpticalField BuildField(const BrickRanges& ranges, glm::ivec3 towards, ClassOf classOf)
{
  const glm::ivec3 count = ranges.BrickCount();
  OpticalField field;
  field.side = ranges.Side();
  field.brickCount = count;
  field.bricks.resize(std::size_t(count.x) * count.y * count.z);
  ChebyshevDistance distance(count, towards);

  // Calls work(index, distance) for each brick.
  const auto forEachBrick = [&](auto&& work)
  {
    tbb::parallel_for(tbb::blocked_range<int>(0, count.y * count.z, 16),
      [&](const tbb::blocked_range<int>& rows)
      {
        for (int row = rows.begin(); row != rows.end(); ++row)
        {
          std::uint8_t* const distances = distance.Row(row % count.y, row / count.y);
          for (int x = 0; x < count.x; ++x)
          {
            work(std::size_t(row) * count.x + x, distances[x]);
          }
        }
      });
  };
  forEachBrick(
    [&](std::size_t brick, std::uint8_t& brickDistance)
    {
      field.bricks[brick] = classOf(brick);
      const bool invisible = field.bricks[brick] == OpticalField::Invisible;
      brickDistance = invisible ? ChebyshevDistance::Farthest : 0;
    });
  distance.Measure();
  forEachBrick([&](std::size_t brick, std::uint8_t brickDistance)
    { field.bricks[brick] += std::max(int(brickDistance) - 1, 0); });
  return field;
}

}

OpticalField BuildOpticalField(const std::vector<OpticalChannel>& channels, const BrickRows& rows,
  const OpticalTolerance& tolerance, glm::ivec3 towards)
{
  const ChannelsClassifier classifier(channels, rows, tolerance);
  return BuildField(
    channels.front().ranges, towards, [&](std::size_t brick) { return classifier.ClassOf(brick); });
}

OpticalField BuildIsosurfaceField(
  const BrickRanges& ranges, const std::vector<double>& isovalues, glm::ivec3 towards)
{
  const auto valueOf = [&](double step)
  { return ranges.FirstValue() + step * ranges.ValuePerStep(); };
  return BuildField(ranges, towards,
    [&](std::size_t brick)
    {
      // Half a step of margin on either side covers rounding.
      const BrickRanges::Steps steps = ranges[brick];
      const double lower = valueOf(steps.smallest - 0.5);
      const double upper = valueOf(steps.largest + 0.5);
      const bool isPassed = std::any_of(isovalues.begin(), isovalues.end(),
        [&](double isovalue) { return lower <= isovalue && isovalue <= upper; });
      return isPassed || !steps.IsFinite() ? OpticalField::Structured : OpticalField::Invisible;
    });
}

double OpticalField::SkippablePart(const Box& boxGrid) const
{
  const double cells = this->side;
  const glm::ivec3 first = glm::max(glm::ivec3(glm::floor(boxGrid.lower / cells)), 0);
  const glm::ivec3 behind =
    glm::min(glm::ivec3(glm::ceil(boxGrid.upper / cells)), this->brickCount);
  std::ptrdiff_t structured = 0;
  std::ptrdiff_t all = 0;
  for (int z = first.z; z < behind.z; ++z)
  {
    for (int y = first.y; y < behind.y; ++y)
    {
      const auto row =
        this->bricks.begin() + (std::ptrdiff_t(z) * this->brickCount.y + y) * this->brickCount.x;
      structured += std::count(row + first.x, row + behind.x, Structured);
      all += behind.x - first.x;
    }
  }
  return all > 0 ? 1.0 - double(structured) / double(all) : 1.0;
}

}
