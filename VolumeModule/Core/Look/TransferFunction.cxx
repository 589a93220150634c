#include "Core/Look/TransferFunction.h"

#include <glm/common.hpp>

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

/// The values between which a quantity of the nodes changes.
/// @param ordinate  returns the quantity of a node that the curve interpolates
template <class Node, class Ordinate>
std::optional<ValueRange> ChangesOf(const std::vector<Node>& nodes, Ordinate ordinate)
{
  const auto differ = [&](const Node& one, const Node& next)
  { return ordinate(one) != ordinate(next); };
  const auto first = std::adjacent_find(nodes.begin(), nodes.end(), differ);
  const auto last = std::adjacent_find(nodes.rbegin(), nodes.rend(), differ);
  return first == nodes.end() ? std::nullopt
                              : std::optional(ValueRange{ first->value, last->value });
}

template <class Node>
void AppendSteps(const std::vector<Node>& nodes, std::vector<Step>& steps)
{
  for (std::size_t i = 1; i < nodes.size(); ++i)
  {
    const Node& left = nodes[i - 1];
    const Node& right = nodes[i];
    if (AreSidesOfStep(left.value, right.value))
    {
      steps.push_back({ right.value, left.value == right.value });
    }
    else if (left.shape.sharpness > LargestSmoothSharpness)
    {
      steps.push_back({ HalfWayValue(left.value, right.value, left.shape), false });
    }
  }
}

// The values of nodes, ascending and without duplicates.
std::vector<double> ValuesOf(
  const std::vector<ColorNode>& colors, const std::vector<OpacityNode>& opacities)
{
  std::vector<double> values;
  for (const ColorNode& node : colors)
  {
    values.push_back(node.value);
  }
  for (const OpacityNode& node : opacities)
  {
    values.push_back(node.value);
  }
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

}

bool AreSidesOfStep(double leftValue, double rightValue)
{
  return rightValue <= std::nextafter(leftValue, std::numeric_limits<double>::infinity());
}

double HalfWayValue(double leftValue, double rightValue, const NodeShape& shape)
{
  return leftValue + SafeMidpoint(shape) * (rightValue - leftValue);
}

double SnappedToStep(const std::vector<Step>& steps, double value, double distance)
{
  const auto next = std::lower_bound(steps.begin(), steps.end(), value - distance,
    [](const Step& step, double limit) { return step.value < limit; });
  return next != steps.end() && next->value <= value + distance ? next->value : value;
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
    node.value = Limited(node.value);
    CheckFinite(node.rgb.r + node.rgb.g + node.rgb.b, "a colour");
    node.rgb = glm::clamp(node.rgb, 0.0, 1.0);
  }
  for (OpacityNode& node : this->opacities)
  {
    node.value = Limited(node.value);
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

std::vector<double> TransferFunction::NodeValues() const
{
  return ValuesOf(this->colors, this->opacities);
}

double TransferFunction::FirstValue() const
{
  const std::vector<double> values = this->NodeValues();
  return values.empty() ? 0.0 : values.front();
}

double TransferFunction::LastValue() const
{
  const std::vector<double> values = this->NodeValues();
  return values.empty() ? 0.0 : values.back();
}

std::optional<ValueRange> TransferFunction::ChangingValues() const
{
  const std::optional<ValueRange> ofColor =
    ChangesOf(this->colors, [](const ColorNode& node) { return node.rgb; });
  const std::optional<ValueRange> ofOpacity =
    ChangesOf(this->opacities, [](const OpacityNode& node) { return node.opacity; });
  if (!ofOpacity)
  {
    // Without opacities, a function gives only the colours of a volume.
    const bool isSeen = this->opacities.empty() || this->opacities.front().opacity > 0.0;
    return isSeen ? ofColor : std::nullopt;
  }
  ValueRange changing = *ofOpacity;
  if (ofColor && this->opacities.front().opacity > 0.0)
  {
    changing.lower = std::min(changing.lower, ofColor->lower);
  }
  if (ofColor && this->opacities.back().opacity > 0.0)
  {
    changing.upper = std::max(changing.upper, ofColor->upper);
  }
  return changing;
}

std::vector<Step> TransferFunction::Steps() const
{
  std::vector<Step> steps;
  AppendSteps(this->colors, steps);
  AppendSteps(this->opacities, steps);
  std::sort(steps.begin(), steps.end(),
    [](const Step& one, const Step& other) { return one.value < other.value; });
  return steps;
}

bool TransferFunction::HasStep() const
{
  return !this->Steps().empty();
}

bool TransferFunction::HasStepAt(double value) const
{
  const std::vector<Step> steps = this->Steps();
  return std::any_of(
    steps.begin(), steps.end(), [&](const Step& step) { return step.value == value; });
}

bool TransferFunction::IsPiecewiseLinear() const
{
  const auto isStraight = [](const auto& nodes)
  {
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
    {
      const NodeShape& shape = nodes[i].shape;
      if (shape.midpoint != 0.5 || shape.sharpness != 0.0 ||
        AreSidesOfStep(nodes[i].value, nodes[i + 1].value))
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
  // A single colour is that of all values: its node lies between no others.
  const std::vector<double> values =
    ValuesOf(this->colors.size() > 1 ? this->colors : std::vector<ColorNode>(), this->opacities);
  for (std::size_t i = 1; i < values.size(); ++i)
  {
    const bool areApart = !AreSidesOfStep(values[i - 1], values[i]);
    smallest = areApart ? std::min(smallest, values[i] - values[i - 1]) : smallest;
  }
  return smallest;
}

}
