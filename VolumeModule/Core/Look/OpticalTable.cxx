#include "Core/Look/OpticalTable.h"

#include <glm/common.hpp>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>

namespace varimarch
{
namespace
{

// Interpolation between entries is linear in extinction, not in opacity, and rounds off a node that
// lies between two entries.
constexpr double EntriesPerNodeGap = 32.0;

// The extinction of a ramp to opacity 1 grows without bound at its end: the entry there is opaque,
// and with it all that is interpolated up to the entry before it.
constexpr std::size_t EntriesOfOpaqueRamp = 8192;

/// True if a function bends visibly between a node and a value one entry behind it.
/// @param nodes  the nodes from that one on
bool Bends(const TransferFunction& transferFunction, std::vector<double>::const_iterator node,
  std::vector<double>::const_iterator end, double gap)
{
  constexpr double Visible = 1.0 / 256.0;
  const auto lookAt = [&](double value)
  { return glm::dvec4(transferFunction.Color(value), transferFunction.Opacity(value)); };
  const double first = *node;
  const glm::dvec4 before = lookAt(first);
  const glm::dvec4 change = lookAt(first + gap) - before;
  for (; node != end && *node < first + gap; ++node)
  {
    const glm::dvec4 off = glm::abs(lookAt(*node) - before - change * ((*node - first) / gap));
    if (std::max({ off.r, off.g, off.b, off.a }) > Visible)
    {
      return true;
    }
  }
  return false;
}

/// True if three nodes in a range lie between two entries that are much farther apart. Two nodes
/// are a step, and three that are not so close are a peak, unless they only follow a curve.
/// @param gap  the distance of the entries
bool MissesCurve(const TransferFunction& transferFunction, ValueRange range, double gap)
{
  constexpr double MuchFarther = 256.0;
  std::vector<double> nodes = transferFunction.NodeValues();
  const auto isOutside = [&](double value) { return value < range.lower || range.upper < value; };
  nodes.erase(std::remove_if(nodes.begin(), nodes.end(), isOutside), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end(), AreSidesOfStep), nodes.end());
  for (std::size_t i = 2; i < nodes.size(); ++i)
  {
    if (MuchFarther * (nodes[i] - nodes[i - 2]) < gap &&
      Bends(transferFunction, nodes.begin() + std::ptrdiff_t(i) - 2, nodes.end(), gap))
    {
      return true;
    }
  }
  return false;
}

/// The values between which the entries of a table lie that tell something apart.
struct TableSpan
{
  double first;      ///< the value of an entry
  double last;       ///< the value of an entry, if all entries are exact there; else near it
  int entriesBefore; ///< 1 if the look just below `first` is another, which needs one more entry
  int entriesBehind; ///< 1 if the look just above `last` is another

  double Length() const { return this->last - this->first; }
  int EntriesBeside() const { return this->entriesBefore + this->entriesBehind; }
};

/// The part of a range of values in which a function changes.
TableSpan SpanOf(const TransferFunction& transferFunction, ValueRange values)
{
  const ValueRange changing =
    transferFunction.ChangingValues().value_or(ValueRange{ values.lower, values.lower });
  TableSpan span{ std::max(values.lower, changing.lower), std::min(values.upper, changing.upper), 0,
    0 };
  for (const Step& step : transferFunction.Steps())
  {
    // Just below a value that is on the right side of its step, the look begins to change there.
    if (!step.valueIsLeft && AreSidesOfStep(changing.lower, step.value) &&
      values.lower < step.value && step.value <= values.upper)
    {
      span.first = step.value;
      span.entriesBefore = 1;
    }
    if (step.valueIsLeft && step.value == changing.upper && values.lower <= step.value &&
      step.value < values.upper)
    {
      span.entriesBehind = 1;
    }
  }
  return span;
}

/// True if a curve rises to opacity 1 without a step and stays there, or falls from it.
bool HasOpaqueRamp(const TransferFunction& transferFunction)
{
  constexpr double Infinity = std::numeric_limits<double>::infinity();
  const std::vector<Step> steps = transferFunction.Steps();
  const auto isRamp = [&](double end)
  {
    return std::isfinite(end) &&
      std::none_of(steps.begin(), steps.end(),
        [&](const Step& step) { return end <= step.value && AreSidesOfStep(end, step.value); });
  };
  const std::vector<ValueRange> ranges = OpaqueValues(transferFunction, { -Infinity, Infinity });
  return std::any_of(ranges.begin(), ranges.end(),
    [&](const ValueRange& range) { return isRamp(range.lower) || isRamp(range.upper); });
}

/// A power of two with enough entries between neighbouring nodes, within the limits.
/// @param finest  the width of the ramp that replaces a step
std::size_t EntryCount(const TableSpan& span, double finest,
  const TransferFunction& transferFunction, std::size_t mostEntries)
{
  // A ramp moves an opaque surface; more entries move it less. Fewer than usual suffice if nothing
  // but the step changes: in finer ones, the rounding of an index would cross it.
  const bool step = transferFunction.HasStep();
  const double wanted = step
    ? span.Length() / finest + span.EntriesBeside()
    : EntriesPerNodeGap * span.Length() / transferFunction.SmallestNodeGap();
  const bool isOpaque = HasOpaqueRamp(transferFunction);
  std::size_t count = step ? 2 : isOpaque ? std::min(EntriesOfOpaqueRamp, mostEntries) : 1024;
  while (double(count) < wanted && 2 * count <= mostEntries)
  {
    count *= 2;
  }
  return std::max<std::size_t>(std::min(count, mostEntries), 2);
}

/// The distance of the entries of a table. Voxels of integers may have the very value of a step,
/// which belongs to one of its sides: where steps are at whole numbers, there are entries too.
double EntryGap(
  const TableSpan& span, double finest, const std::vector<Step>& steps, std::size_t count)
{
  if (!(span.Length() > 0.0))
  {
    return finest;
  }
  const double gap =
    span.Length() / std::max(double(count) - 1.0 - double(span.EntriesBeside()), 1.0);
  const auto isWhole = [](double value) { return value == std::round(value); };
  const bool areWhole = !steps.empty() && isWhole(span.first) &&
    std::all_of(steps.begin(), steps.end(), [&](const Step& step) { return isWhole(step.value); });
  return areWhole && gap < 1.0 ? 1.0 / std::floor(1.0 / gap) : gap;
}

glm::vec4 OpticalEntry(const TransferFunction& transferFunction, double value)
{
  const double extinction = std::min(transferFunction.Extinction(value), double(OpaqueExtinction));
  return glm::vec4(transferFunction.Color(value), extinction);
}

/// The values in (lower, upper) at which the opacity has nodes, each once.
std::vector<double> OpacityNodesIn(
  const TransferFunction& transferFunction, double lower, double upper)
{
  std::vector<double> values;
  for (const OpacityNode& node : transferFunction.Opacities())
  {
    const bool known = !values.empty() && AreSidesOfStep(values.back(), node.value);
    if (lower < node.value && node.value < upper && !known)
    {
      values.push_back(node.value);
    }
  }
  return values;
}

/// True if the curve is opaque at a value but on neither side of it, as at the tip of a tent. Such
/// a value transmits light: the extinction next to it grows like a logarithm, whose integral is
/// finite.
bool IsOpaqueInPassing(const TransferFunction& transferFunction, double value, double gap)
{
  return std::isinf(transferFunction.Extinction(value)) &&
    !std::isinf(transferFunction.Extinction(value - gap)) &&
    !std::isinf(transferFunction.Extinction(value + gap));
}

/// The entry at a value of a table whose entries are `gap` apart. If several nodes lie within one
/// entry on either side, a sample would miss what is between them, and a sample at an opaque tip
/// would be a wall. The entry is then the mean under its hat function, which preserves the
/// integral.
glm::vec4 EntryAt(const TransferFunction& transferFunction, double value, double gap)
{
  std::vector<double> ends = OpacityNodesIn(transferFunction, value - gap, value + gap);
  if (ends.size() < 2 && !IsOpaqueInPassing(transferFunction, value, gap))
  {
    return OpticalEntry(transferFunction, value);
  }
  ends.insert(ends.begin(), value - gap);
  ends.push_back(value + gap);
  constexpr int Points = 32; // samples between neighbouring nodes
  double extinction = 0.0;
  glm::dvec3 emission(0.0);
  for (std::size_t i = 0; i + 1 < ends.size(); ++i)
  {
    const double width = (ends[i + 1] - ends[i]) / Points;
    for (int point = 0; point < Points; ++point)
    {
      const double place = ends[i] + (point + 0.5) * width;
      const double weight = (1.0 - std::abs(place - value) / gap) * width / gap;
      const glm::dvec4 sample(OpticalEntry(transferFunction, place));
      extinction += weight * sample.a;
      emission += weight * sample.a * glm::dvec3(sample);
    }
  }
  // The weights add up to 1 but for rounding.
  const glm::dvec3 color = extinction > 0.0 ? glm::min(emission / extinction, glm::dvec3(1.0))
                                            : transferFunction.Color(value);
  return glm::vec4(color, std::min(extinction, double(OpaqueExtinction)));
}

}

OpticalTable BuildOpticalTable(const TransferFunction& transferFunction, double smallestValue,
  double largestValue, std::size_t mostEntries)
{
  if (!(smallestValue <= largestValue && std::isfinite(smallestValue) &&
        std::isfinite(largestValue)))
  {
    throw std::invalid_argument("Optical table: the range of values must be finite and not "
                                "reversed, found " +
      std::to_string(smallestValue) + " to " + std::to_string(largestValue));
  }

  const double finest = largestValue / mostEntries - smallestValue / mostEntries;
  const TableSpan span = SpanOf(transferFunction, { smallestValue, largestValue });
  if (!(span.Length() > SmallestDifference) && span.EntriesBeside() == 0)
  {
    const glm::vec4 everywhere = OpticalEntry(transferFunction, smallestValue);
    return { smallestValue, largestValue, { everywhere, everywhere } };
  }

  const std::vector<Step> steps = transferFunction.Steps();
  const std::size_t count = EntryCount(span, finest, transferFunction, mostEntries);
  const double gap = EntryGap(span, finest, steps, count);
  const double first = span.first - span.entriesBefore * gap;
  const double last = first + double(count - 1) * gap;
  OpticalTable table{ first, last, std::vector<glm::vec4>(count),
    MissesCurve(transferFunction, { first, last }, gap) };
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 4096),
    [&](const tbb::blocked_range<std::size_t>& range)
    {
      for (std::size_t i = range.begin(); i < range.end(); ++i)
      {
        const double value = SnappedToStep(steps, first + double(i) * gap, 1e-6 * gap);
        const bool isEnd = i == 0 || i == count - 1;
        table.entries[i] = isEnd && !IsOpaqueInPassing(transferFunction, value, gap)
          ? OpticalEntry(transferFunction, value)
          : EntryAt(transferFunction, value, gap);
      }
    });
  return table;
}

IndexInTable IndexOf(
  const OpticalTable& table, double lastIndex, double valueScale, double valueOffset)
{
  constexpr double Most = 1e30;
  const double extent = table.lastValue - table.firstValue;
  const double indexPerValue = extent > SmallestDifference ? lastIndex / extent : 0.0;
  return { std::min(valueScale * indexPerValue, Most),
    std::clamp((valueOffset - table.firstValue) * indexPerValue, -Most, Most) };
}

std::array<double, 2> VisibleValues(const OpticalTable& table)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto absorbs = [](const glm::vec4& entry) { return entry.a > 0.0f; };
  const auto first = std::find_if(table.entries.begin(), table.entries.end(), absorbs);
  if (first == table.entries.end())
  {
    return { infinity, -infinity };
  }
  const auto behindLast =
    std::find_if(table.entries.rbegin(), table.entries.rend(), absorbs).base();
  const auto valueAt = [&](auto entry)
  {
    const double fraction =
      double(entry - table.entries.begin()) / double(table.entries.size() - 1);
    return (1.0 - fraction) * table.firstValue + fraction * table.lastValue;
  };
  return { first == table.entries.begin() ? -infinity : valueAt(first - 1),
    behindLast == table.entries.end() ? infinity : valueAt(behindLast) };
}

std::vector<ValueRange> OpaqueValues(
  const TransferFunction& transferFunction, const ValueRange& values)
{
  constexpr double Infinity = std::numeric_limits<double>::infinity();
  const std::vector<OpacityNode>& nodes = transferFunction.Opacities();
  std::vector<ValueRange> ranges;
  for (std::size_t first = 0; first < nodes.size(); ++first)
  {
    std::size_t behind = first;
    while (behind < nodes.size() && nodes[behind].opacity >= 1.0)
    {
      ++behind;
    }
    if (behind == first)
    {
      continue;
    }
    const ValueRange range{ first == 0 ? -Infinity : nodes[first].value,
      behind == nodes.size() ? Infinity : nodes[behind - 1].value };
    const bool beginsInside = values.lower < range.lower && range.lower <= values.upper;
    const bool endsInside = values.lower <= range.upper && range.upper < values.upper;
    if (range.lower < range.upper && (beginsInside || endsInside))
    {
      ranges.push_back(range);
    }
    first = behind;
  }
  return ranges;
}

}
