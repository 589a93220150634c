#include "Core/Look/TransferFunction.h"

#include <glm/common.hpp>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace varimarch
{

namespace
{

/// Keeps the midpoint off the nodes, so that both halves of the curve have a width.
double SafeMidpoint(const NodeShape& shape)
{
  return std::clamp(shape.midpoint, 0.00001, 0.99999);
}

/// Curves with a larger sharpness are steps.
constexpr double LargestSmoothSharpness = 0.99;

/// Distance of a curve from the nearer of its two nodes, as a fraction of their difference, [0,
/// 1/2], at the fraction `s` of the way, where 1/2 is the midpoint. The curve is that of
/// vtkPiecewiseFunction and vtkColorTransferFunction: a Hermite cubic whose tangents flatten and
/// whose parameter is compressed towards the midpoint as the sharpness grows. It is symmetric in
/// the two nodes.
double Departure(double s, double sharpness)
{
  if (sharpness > LargestSmoothSharpness)
  {
    return 0.0;
  }
  if (sharpness < 0.01)
  {
    return s;
  }
  s = 0.5 * std::pow(2.0 * s, 1.0 + 10.0 * sharpness);
  const double smoothStep = s * s * (3.0 - 2.0 * s);
  const double bothTangents = s * (2.0 * s - 1.0) * (s - 1.0);
  return smoothStep + (1.0 - sharpness) * bothTangents;
}

/// The curve through `nodes`, of which there is at least one, at `value`.
/// @param ordinate  returns the quantity of a node that the curve interpolates
template <class Node, class Ordinate>
auto CurveValue(const std::vector<Node>& nodes, double value, Ordinate ordinate)
{
  // The first node at or right of the value; at a step this selects the left side.
  const auto right = std::lower_bound(nodes.begin(), nodes.end(), value,
    [](const Node& node, double limit) { return node.value < limit; });
  if (right == nodes.begin())
  {
    return ordinate(nodes.front());
  }
  if (right == nodes.end())
  {
    return ordinate(nodes.back());
  }
  const Node& left = *(right - 1);
  const double gap = right->value - left.value;
  const double fromLeft = (value - left.value) / gap;
  const double fromRight = (right->value - value) / gap;

  // Measured from the nearer node, so that it is exact at both nodes and between equal ones.
  const double midpoint = SafeMidpoint(left.shape);
  const bool leftIsNearer = value < HalfWayValue(left.value, right->value, left.shape);
  const double s = leftIsNearer ? 0.5 * fromLeft / midpoint : 0.5 * fromRight / (1.0 - midpoint);
  const auto nearer = ordinate(leftIsNearer ? left : *right);
  const auto farther = ordinate(leftIsNearer ? *right : left);
  return nearer + Departure(s, left.shape.sharpness) * (farther - nearer);
}

void CheckFinite(double number, const char* what)
{
  if (!std::isfinite(number))
  {
    throw std::invalid_argument(std::string("Transfer function: ") + what +
      " must be finite, found " + std::to_string(number));
  }
}

template <class Node>
void CheckNodes(const std::vector<Node>& nodes)
{
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    CheckFinite(nodes[i].value, "a node's value");
    CheckFinite(nodes[i].shape.midpoint, "a node's midpoint");
    CheckFinite(nodes[i].shape.sharpness, "a node's sharpness");
    if (i > 0 && nodes[i].value < nodes[i - 1].value)
    {
      throw std::invalid_argument("Transfer function: nodes must be sorted by value, found " +
        std::to_string(nodes[i].value) + " after " + std::to_string(nodes[i - 1].value));
    }
  }
}

/// True if the last two nodes are both at `value`, where they make a step.
template <class Node>
bool EndsWithStep(const std::vector<Node>& nodes, double value)
{
  return nodes.size() >= 2 && nodes.back().value == value && nodes[nodes.size() - 2].value == value;
}

std::vector<double> SortedNodeValues(const TransferFunction& transferFunction)
{
  std::vector<double> values;
  for (const ColorNode& node : transferFunction.Colors())
  {
    values.push_back(node.value);
  }
  for (const OpacityNode& node : transferFunction.Opacities())
  {
    values.push_back(node.value);
  }
  std::sort(values.begin(), values.end());
  return values;
}

}

double HalfWayValue(double leftValue, double rightValue, const NodeShape& shape)
{
  return leftValue + SafeMidpoint(shape) * (rightValue - leftValue);
}

TransferFunction::TransferFunction(
  std::vector<ColorNode> colors, std::vector<OpacityNode> opacities, double opacityUnitDistanceMm)
  : colors(std::move(colors))
  , opacities(std::move(opacities))
  , opacityUnitDistanceMm(opacityUnitDistanceMm)
{
  CheckFinite(opacityUnitDistanceMm, "the opacity unit distance");
  if (!(opacityUnitDistanceMm > 0.0))
  {
    throw std::invalid_argument("Transfer function: the opacity unit distance must be above 0 mm, "
                                "found " +
      std::to_string(opacityUnitDistanceMm));
  }
  CheckNodes(this->colors);
  CheckNodes(this->opacities);
  for (ColorNode& node : this->colors)
  {
    CheckFinite(node.rgb.r + node.rgb.g + node.rgb.b, "a colour");
    node.rgb = glm::clamp(node.rgb, 0.0, 1.0);
  }
  for (OpacityNode& node : this->opacities)
  {
    CheckFinite(node.opacity, "an opacity");
    node.opacity = std::clamp(node.opacity, 0.0, 1.0);
  }
}

glm::dvec3 TransferFunction::Color(double value) const
{
  const auto rgb = [](const ColorNode& node) { return node.rgb; };
  return this->colors.empty() ? glm::dvec3(1.0) : CurveValue(this->colors, value, rgb);
}

double TransferFunction::Opacity(double value) const
{
  const bool nothing = this->opacities.empty() || std::isnan(value);
  const auto opacity = [](const OpacityNode& node) { return node.opacity; };
  return nothing ? 0.0 : CurveValue(this->opacities, value, opacity);
}

double TransferFunction::Extinction(double value) const
{
  const double opacity = this->Opacity(value);
  if (opacity < 0.5)
  {
    return -std::log1p(-opacity) / this->opacityUnitDistanceMm;
  }
  // Interpolates the transparency. Near an opaque node 1 - opacity would round to 0, and a thin
  // veil would become a wall. The logarithm of 0 is minus infinity, so opaque values need no
  // branch.
  const auto transparency = [](const OpacityNode& node) { return 1.0 - node.opacity; };
  return -std::log(CurveValue(this->opacities, value, transparency)) / this->opacityUnitDistanceMm;
}

double TransferFunction::FirstValue() const
{
  const std::vector<double> values = SortedNodeValues(*this);
  return values.empty() ? 0.0 : values.front();
}

double TransferFunction::LastValue() const
{
  const std::vector<double> values = SortedNodeValues(*this);
  return values.empty() ? 0.0 : values.back();
}

bool TransferFunction::IsPiecewiseLinear() const
{
  const auto isStraight = [](const auto& nodes)
  {
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
    {
      const NodeShape& shape = nodes[i].shape;
      if (shape.midpoint != 0.5 || shape.sharpness != 0.0 || nodes[i].value == nodes[i + 1].value)
      {
        return false;
      }
    }
    return true;
  };
  return isStraight(this->colors) && isStraight(this->opacities);
}

double TransferFunction::SmallestNodeGap() const
{
  double smallest = std::numeric_limits<double>::infinity();
  const std::vector<double> values = SortedNodeValues(*this);
  for (std::size_t i = 1; i < values.size(); ++i)
  {
    if (values[i] != values[i - 1])
    {
      smallest = std::min(smallest, values[i] - values[i - 1]);
    }
  }
  return smallest;
}

namespace
{

// Interpolation between entries is linear in extinction, not in opacity, and rounds off a node that
// lies between two entries.
constexpr double EntriesPerNodeGap = 32.0;

/// True if the curve jumps anywhere.
template <class Node>
bool HasStep(const std::vector<Node>& nodes)
{
  const auto isStep = [](const Node& node, const Node& next)
  { return node.value == next.value || node.shape.sharpness > LargestSmoothSharpness; };
  return std::adjacent_find(nodes.begin(), nodes.end(), isStep) != nodes.end();
}

/// A power of two with enough entries between neighbouring nodes, within the limits.
std::size_t EntryCount(
  double length, const TransferFunction& transferFunction, std::size_t mostEntries)
{
  // A step becomes a ramp one entry wide, which moves an opaque surface; more entries move it less.
  const bool step = HasStep(transferFunction.Colors()) || HasStep(transferFunction.Opacities());
  const double wanted =
    step ? mostEntries : EntriesPerNodeGap * length / transferFunction.SmallestNodeGap();
  std::size_t count = 1024;
  while (double(count) < wanted && 2 * count <= mostEntries)
  {
    count *= 2;
  }
  return std::max<std::size_t>(std::min(count, mostEntries), 2);
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
    const bool known = !values.empty() && values.back() == node.value;
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
  const glm::dvec3 color = extinction > 0.0 ? emission / extinction : transferFunction.Color(value);
  return glm::vec4(color, extinction);
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

  // The range where the function changes; a step at its end needs one more entry.
  const double end = transferFunction.LastValue();
  const bool stepAtEnd =
    EndsWithStep(transferFunction.Colors(), end) || EndsWithStep(transferFunction.Opacities(), end);
  const double finest = (largestValue / mostEntries - smallestValue / mostEntries);
  const double first = std::max(smallestValue, transferFunction.FirstValue());
  const double last = std::min(largestValue, stepAtEnd ? end + finest : end);
  if (!(first < last))
  {
    const glm::vec4 everywhere = OpticalEntry(transferFunction, smallestValue);
    return { smallestValue, largestValue, { everywhere, everywhere } };
  }

  const std::size_t count = EntryCount(last - first, transferFunction, mostEntries);
  const double gap = (last - first) / double(count - 1);
  OpticalTable table{ first, last, std::vector<glm::vec4>(count) };
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 4096),
    [&](const tbb::blocked_range<std::size_t>& range)
    {
      for (std::size_t i = range.begin(); i < range.end(); ++i)
      {
        const double fraction = double(i) / double(count - 1);
        table.entries[i] =
          EntryAt(transferFunction, (1.0 - fraction) * first + fraction * last, gap);
      }
    });
  return table;
}

IndexInTable IndexOf(
  const OpticalTable& table, double lastIndex, double valueScale, double valueOffset)
{
  const double extent = table.lastValue - table.firstValue;
  const double indexPerValue = extent > 0.0 ? lastIndex / extent : 0.0;
  return { valueScale * indexPerValue, (valueOffset - table.firstValue) * indexPerValue };
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
  const double gap = (table.lastValue - table.firstValue) / double(table.entries.size() - 1);
  const auto valueAt = [&](auto entry)
  { return table.firstValue + gap * double(entry - table.entries.begin()); };
  return { first == table.entries.begin() ? -infinity : valueAt(first - 1),
    behindLast == table.entries.end() ? infinity : valueAt(behindLast) };
}

}
