#include "Frame/PropertyTransferFunction.h"

#include "Core/Look/TransferFunction.h"

#include "vtkColorTransferFunction.h"
#include "vtkDiscretizableColorTransferFunction.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace varimarch
{

namespace
{

/// A colour at each value.
using ColorCurve = std::function<glm::dvec3(double value)>;

/// How values between two others are spread: evenly, or evenly in their logarithm.
enum class CurveScale
{
  Linear,
  Logarithmic,
};

// The distance of straight pieces from the curve, far below the resolution of a display.
constexpr double Deviation = 1.0 / 20000.0;

// The pieces between two nodes in which every curve is examined, so that none of its waves is
// missed.
constexpr int FewestPieces = 16;

// A piece is halved so often before the difference of its ends counts as a jump.
constexpr int MostHalvings = 16;

double DistanceOf(const glm::dvec3& one, const glm::dvec3& other)
{
  const glm::dvec3 apart = glm::abs(one - other);
  return std::max({ apart.r, apart.g, apart.b });
}

// Appends nodes behind one of a curve up to the next.
class CurveFollower
{
public:
  CurveFollower(const ColorCurve& curve, CurveScale scale, std::vector<ColorNode>& nodes)
    : curve(curve)
    , scale(scale)
    , nodes(nodes)
  {
  }

  ColorNode Between(const ColorNode& left, const ColorNode& right, double fraction) const
  {
    return this->At(this->scale == CurveScale::Linear
        ? glm::mix(left.value, right.value, fraction)
        : left.value * std::pow(right.value / left.value, fraction));
  }

  void Append(const ColorNode& left, const ColorNode& right, int halvings) const
  {
    const ColorNode middle = this->Between(left, right, 0.5);
    if (!(left.value < middle.value && middle.value < right.value) ||
      this->IsStraight(left, middle, right))
    {
      this->nodes.push_back(right);
    }
    else if (halvings == 0)
    {
      this->AppendJump(left, right);
    }
    else
    {
      this->Append(left, middle, halvings - 1);
      this->Append(middle, right, halvings - 1);
    }
  }

private:
  ColorNode At(double value) const { return { value, glm::clamp(this->curve(value), 0.0, 1.0) }; }

  bool IsStraight(const ColorNode& left, const ColorNode& middle, const ColorNode& right) const
  {
    const auto isOnPiece = [&](const ColorNode& node)
    {
      const double fraction = (node.value - left.value) / (right.value - left.value);
      return DistanceOf(node.rgb, glm::mix(left.rgb, right.rgb, fraction)) <= Deviation;
    };
    return isOnPiece(middle) && isOnPiece(this->Between(left, right, 0.25)) &&
      isOnPiece(this->Between(left, right, 0.75));
  }

  // The value of a jump at the left end of the piece, where the curve has a node, belongs to the
  // left side; that of any other to the right side.
  void AppendJump(const ColorNode& left, const ColorNode& right) const
  {
    constexpr int MostBisections = 128;
    ColorNode before = left;
    ColorNode behind = right;
    for (int i = 0; i < MostBisections && !AreSidesOfStep(before.value, behind.value); ++i)
    {
      const ColorNode middle = this->At(0.5 * before.value + 0.5 * behind.value);
      const bool isBefore = DistanceOf(middle.rgb, before.rgb) < DistanceOf(middle.rgb, behind.rgb);
      (isBefore ? before : behind) = middle;
    }
    if (before.value == left.value)
    {
      this->nodes.push_back({ left.value, behind.rgb });
    }
    else
    {
      constexpr double infinity = std::numeric_limits<double>::infinity();
      this->nodes.push_back({ std::nextafter(behind.value, -infinity), before.rgb });
      this->nodes.push_back(behind);
    }
    if (behind.value < right.value)
    {
      this->nodes.push_back(right);
    }
  }

  const ColorCurve& curve;
  CurveScale scale;
  std::vector<ColorNode>& nodes;
};

// True if a node lies on the straight piece between its neighbours, as many do beside a jump.
bool IsNeedless(const ColorNode& left, const ColorNode& node, const ColorNode& right)
{
  constexpr double Rounding = 1e-9;
  const double fraction = (node.value - left.value) / (right.value - left.value);
  return !AreSidesOfStep(left.value, node.value) && !AreSidesOfStep(node.value, right.value) &&
    DistanceOf(node.rgb, glm::mix(left.rgb, right.rgb, fraction)) <= Rounding;
}

void AppendWithoutNeedless(const std::vector<ColorNode>& followed, std::vector<ColorNode>& nodes)
{
  const std::size_t first = nodes.size();
  for (const ColorNode& node : followed)
  {
    while (nodes.size() > first + 1 && IsNeedless(nodes[nodes.size() - 2], nodes.back(), node))
    {
      nodes.pop_back();
    }
    nodes.push_back(node);
  }
}

/// Appends nodes that follow a curve from the last of `nodes` to another node, by straight pieces
/// whose distance from the curve is at most 1/20000 in [0, 1]. A jump of the curve becomes a step.
/// @param curve  it may leave [0, 1], to which the nodes are limited
/// @param nodes  at least one; its last has the value of the curve there
/// @param scale  the scale on which the curve is about as smooth everywhere
void Follow(
  const ColorCurve& curve, const ColorNode& end, CurveScale scale, std::vector<ColorNode>& nodes)
{
  const ColorNode begin = nodes.back();
  std::vector<ColorNode> followed = { begin };
  const CurveFollower follower(curve, scale, followed);
  ColorNode left = begin;
  for (int piece = 1; piece <= FewestPieces; ++piece)
  {
    const ColorNode right =
      piece < FewestPieces ? follower.Between(begin, end, double(piece) / FewestPieces) : end;
    follower.Append(left, right, MostHalvings);
    left = right;
  }
  nodes.pop_back();
  AppendWithoutNeedless(followed, nodes);
}

constexpr double infinity = std::numeric_limits<double>::infinity();

// A node of a vtkPiecewiseFunction.
struct CurveNode
{
  double value;
  double ordinate;
  NodeShape shape;
};

std::vector<CurveNode> CurveNodesOf(vtkPiecewiseFunction* function)
{
  std::vector<CurveNode> nodes;
  for (int i = 0; i < function->GetSize(); ++i)
  {
    double node[4]; // value, ordinate, midpoint, sharpness
    function->GetNodeValue(i, node);
    nodes.push_back({ node[0], node[1], { node[2], node[3] } });
  }
  return nodes;
}

// The nodes of a vtkColorTransferFunction. The colours may exceed [0, 1].
std::vector<ColorNode> ColorNodesOf(vtkColorTransferFunction* function)
{
  std::vector<ColorNode> nodes;
  for (int i = 0; i < function->GetSize(); ++i)
  {
    double node[6]; // value, r, g, b, midpoint, sharpness
    function->GetNodeValue(i, node);
    nodes.push_back({ node[0], { node[1], node[2], node[3] }, { node[4], node[5] } });
  }
  return nodes;
}

bool CanBeLogarithmic(vtkPiecewiseFunction* function)
{
  return function->GetSize() > 0 && function->GetRange()[0] > 0.0;
}

bool IsWithinOne(const glm::dvec3& rgb)
{
  return glm::clamp(rgb, 0.0, 1.0) == rgb;
}

// A curve that is not clamped is 0 beyond its ends.
void StepToNothingAtEnds(std::vector<OpacityNode>& nodes)
{
  if (!nodes.empty())
  {
    nodes.insert(nodes.begin(), OpacityNode{ nodes.front().value, 0.0 });
    nodes.push_back(OpacityNode{ nodes.back().value, 0.0 });
  }
}

bool IsFinite(const ColorNode& node)
{
  return std::isfinite(node.value + node.rgb.r + node.rgb.g + node.rgb.b);
}

// Nodes that follow a curve from each of the given nodes to the next.
template <class CurveFrom>
std::vector<ColorNode> Followed(
  const std::vector<ColorNode>& given, CurveScale scale, const CurveFrom& curveFrom)
{
  std::vector<ColorNode> nodes = { { given.front().value,
    glm::clamp(given.front().rgb, 0.0, 1.0) } };
  for (std::size_t i = 1; i < given.size(); ++i)
  {
    const ColorNode end{ given[i].value, glm::clamp(given[i].rgb, 0.0, 1.0) };
    if (IsFinite(nodes.back()) && IsFinite(end) && nodes.back().value < end.value)
    {
      Follow(curveFrom(i - 1), end, scale, nodes);
    }
    else
    {
      nodes.push_back(end);
    }
  }
  return nodes;
}

// The opacities as gray nodes.
std::vector<OpacityNode> FollowedOpacities(
  vtkPiecewiseFunction* function, const std::vector<CurveNode>& given, CurveScale scale)
{
  std::vector<ColorNode> gray;
  for (const CurveNode& node : given)
  {
    gray.push_back({ node.value, glm::dvec3(node.ordinate) });
  }
  const ColorCurve curve = [=](double value) { return glm::dvec3(function->GetValue(value)); };
  std::vector<OpacityNode> nodes;
  for (const ColorNode& node : Followed(gray, scale, [&](std::size_t) { return curve; }))
  {
    nodes.push_back({ node.value, node.rgb.r });
  }
  return nodes;
}

// The function if its colours come from a table instead of the nodes; else null.
vtkDiscretizableColorTransferFunction* TableIn(vtkColorTransferFunction* function)
{
  auto* const table = vtkDiscretizableColorTransferFunction::SafeDownCast(function);
  return table && table->GetDiscretize() ? table : nullptr;
}

bool IsLogarithmic(vtkColorTransferFunction* function)
{
  return function->GetScale() == VTK_CTF_LOG10 && function->GetRange()[0] > 0.0;
}

glm::dvec3 ColorAt(vtkColorTransferFunction* function, double value)
{
  glm::dvec3 rgb;
  function->GetColor(value, &rgb[0]);
  return rgb;
}

// True if the nodes alone describe the colours between them.
bool IsLinearRgb(vtkColorTransferFunction* function, const std::vector<ColorNode>& nodes)
{
  return function->GetColorSpace() == VTK_CTF_RGB && !IsLogarithmic(function) &&
    std::all_of(
      nodes.begin(), nodes.end(), [](const ColorNode& node) { return IsWithinOne(node.rgb); });
}

// The colours between two nodes in the colour space CIEDE2000, for which VTK searches the path
// between them anew, in a tenth of a second, for each table or colour that it is asked for.
ColorCurve PathBetween(
  vtkColorTransferFunction* function, const ColorNode& left, const ColorNode& right)
{
  constexpr int Entries = 4097;
  vtkNew<vtkColorTransferFunction> path;
  path->SetColorSpace(function->GetColorSpace());
  path->AddRGBPoint(
    0.0, left.rgb.r, left.rgb.g, left.rgb.b, left.shape.midpoint, left.shape.sharpness);
  path->AddRGBPoint(1.0, right.rgb.r, right.rgb.g, right.rgb.b);
  std::vector<glm::dvec3> colors(Entries);
  path->GetTable(0.0, 1.0, Entries, &colors.front()[0]);
  const bool isLogarithmic = IsLogarithmic(function);
  return [=](double value)
  {
    const double fraction = isLogarithmic
      ? std::log(value / left.value) / std::log(right.value / left.value)
      : (value - left.value) / (right.value - left.value);
    const double place = std::clamp(fraction, 0.0, 1.0) * (Entries - 1);
    const int entry = std::min(int(place), Entries - 2);
    return glm::mix(colors[entry], colors[entry + 1], place - entry);
  };
}

std::vector<ColorNode> FollowedColors(
  vtkColorTransferFunction* function, const std::vector<ColorNode>& given)
{
  const bool hasPaths = function->GetColorSpace() == VTK_CTF_LAB_CIEDE2000;
  const auto curveFrom = [&](std::size_t i)
  {
    return hasPaths ? PathBetween(function, given[i], given[i + 1])
                    : ColorCurve([=](double value) { return ColorAt(function, value); });
  };
  const CurveScale scale = IsLogarithmic(function) ? CurveScale::Logarithmic : CurveScale::Linear;
  return Followed(given, scale, curveFrom);
}

// The colours of a table, each of which holds for an equal part of the range.
std::vector<ColorNode> TableNodesOf(vtkDiscretizableColorTransferFunction* table)
{
  const double first = table->GetRange()[0];
  const double last = table->GetRange()[1];
  const bool isLogarithmic = table->GetUseLogScale() && first * last > 0.0;
  const auto valueAt = [&](double fraction)
  {
    return isLogarithmic ? first * std::pow(last / first, fraction)
                         : glm::mix(first, last, fraction);
  };
  const double count = double(std::max<vtkIdType>(table->GetNumberOfValues(), 1));
  std::vector<ColorNode> nodes = { { first, ColorAt(table, valueAt(0.5 / count)) } };
  for (double i = 1.0; i < count && first < last; ++i)
  {
    const glm::dvec3 rgb = ColorAt(table, valueAt((i + 0.5) / count));
    if (rgb != nodes.back().rgb)
    {
      const double value = valueAt(i / count);
      nodes.push_back({ std::nextafter(value, -infinity), nodes.back().rgb });
      nodes.push_back({ value, rgb });
    }
  }
  nodes.push_back({ last, nodes.back().rgb });
  return nodes;
}

// Colours beyond the nodes. The values of the first and the last node are inside.
void StepAtEnds(vtkColorTransferFunction* function, std::vector<ColorNode>& nodes)
{
  const double first = nodes.front().value;
  const double last = nodes.back().value;
  const double width = std::max({ last - first, std::abs(first), std::abs(last), 1.0 });
  const bool isLogarithmic = IsLogarithmic(function);
  const glm::dvec3 below =
    glm::clamp(ColorAt(function, isLogarithmic ? 0.5 * first : first - width), 0.0, 1.0);
  const glm::dvec3 above =
    glm::clamp(ColorAt(function, isLogarithmic ? 2.0 * last : last + width), 0.0, 1.0);
  if (below != nodes.front().rgb)
  {
    nodes.insert(nodes.begin(), { std::nextafter(first, -infinity), below });
  }
  if (above != nodes.back().rgb)
  {
    nodes.push_back({ last, above });
  }
}

/// The nodes of an opacity curve. They are VTK's own, with midpoints and sharpness, if the curve is
/// linear between values and stays within [0, 1]; otherwise the nodes follow it to 1/20000. A curve
/// that is not clamped steps to 0 at its ends. On a logarithmic scale VTK's function has no values
/// between nodes that are not above 0; a curve with such nodes is linear.
/// The nodes of a colour function: VTK's own if it interpolates linearly in RGB within [0, 1];
/// otherwise they follow it, also one of a subclass, to 1/20000, and its jumps exactly. An indexed
/// lookup is ignored. A function without nodes is black.
std::vector<OpacityNode> NodesOf(vtkPiecewiseFunction* function)
{
  const std::vector<CurveNode> given = CurveNodesOf(function);
  const bool isLogarithmic = function->GetUseLogScale() && CanBeLogarithmic(function);
  const bool isWithinOne = std::all_of(given.begin(), given.end(),
    [](const CurveNode& node) { return IsWithinOne(glm::dvec3(node.ordinate)); });
  std::vector<OpacityNode> nodes;
  if (isLogarithmic || !isWithinOne)
  {
    nodes = FollowedOpacities(
      function, given, isLogarithmic ? CurveScale::Logarithmic : CurveScale::Linear);
  }
  else
  {
    for (const CurveNode& node : given)
    {
      nodes.push_back({ node.value, node.ordinate, node.shape });
    }
  }
  if (!function->GetClamping())
  {
    StepToNothingAtEnds(nodes);
  }
  return nodes;
}

std::vector<ColorNode> NodesOf(vtkColorTransferFunction* function)
{
  std::vector<ColorNode> given = ColorNodesOf(function);
  if (function->GetIndexedLookup())
  {
    return given;
  }
  if (given.empty())
  {
    given.push_back({ 0.0, glm::dvec3(0.0) });
  }
  std::vector<ColorNode> nodes = TableIn(function) ? TableNodesOf(TableIn(function))
    : IsLinearRgb(function, given)                 ? given
                                                   : FollowedColors(function, given);
  StepAtEnds(function, nodes);
  return nodes;
}

/// The gray nodes of an opacity curve.
std::vector<ColorNode> GrayNodesOf(vtkPiecewiseFunction* function)
{
  std::vector<ColorNode> nodes;
  for (const OpacityNode& node : NodesOf(function))
  {
    nodes.push_back({ node.value, glm::dvec3(node.opacity), node.shape });
  }
  if (nodes.empty())
  {
    nodes.push_back({ 0.0, glm::dvec3(0.0) });
  }
  return nodes;
}

/// Sentences that name what an image of a function lacks, each followed by a space; empty if it
/// lacks nothing.
std::string MissingFeatures(vtkPiecewiseFunction* function)
{
  if (!function->GetUseLogScale() || CanBeLogarithmic(function))
  {
    return {};
  }
  std::ostringstream sentence;
  sentence
    << "A piecewise function on a logarithmic scale (UseLogScale) needs nodes above 0, found "
    << function->GetRange()[0] << ": its scale is linear. ";
  return sentence.str();
}

std::string MissingFeatures(vtkColorTransferFunction* function)
{
  return function->GetIndexedLookup()
    ? "Colours of annotated values (IndexedLookup) are not supported for volumes. "
    : "";
}

}

TransferFunction TransferFunctionOf(vtkVolumeProperty* property, int component)
{
  std::vector<ColorNode> colors = property->GetColorChannels(component) == 1
    ? GrayNodesOf(property->GetGrayTransferFunction(component))
    : NodesOf(property->GetRGBTransferFunction(component));
  return TransferFunction(std::move(colors), NodesOf(property->GetScalarOpacity(component)),
    property->GetScalarOpacityUnitDistance(component));
}

std::vector<int> LabelsOf(vtkVolumeProperty* property)
{
  const std::set<int> labels = property->GetLabelMapLabels();
  return std::vector<int>(labels.begin(), labels.end());
}

TransferFunction LabelTransferFunctionOf(
  vtkVolumeProperty* property, int label, const TransferFunction& without)
{
  vtkColorTransferFunction* const color = property->GetLabelColor(label);
  vtkPiecewiseFunction* const opacity = property->GetLabelScalarOpacity(label);
  return TransferFunction(color ? NodesOf(color) : without.Colors(),
    opacity ? NodesOf(opacity) : without.Opacities(), without.OpacityUnitDistanceMm());
}

TransferFunction OpacityCurveOf(vtkPiecewiseFunction* function)
{
  return TransferFunction({}, NodesOf(function), 1.0);
}

std::string MissingFunctionFeatures(vtkVolumeProperty* property, int components)
{
  std::set<std::string> sentences;
  for (int component = 0; component < components; ++component)
  {
    property->GetColorChannels(component) == 1
      ? sentences.insert(MissingFeatures(property->GetGrayTransferFunction(component)))
      : sentences.insert(MissingFeatures(property->GetRGBTransferFunction(component)));
    sentences.insert(MissingFeatures(property->GetScalarOpacity(component)));
    if (property->HasGradientOpacity(component))
    {
      sentences.insert(MissingFeatures(property->GetGradientOpacity(component)));
    }
  }
  for (const int label : LabelsOf(property))
  {
    vtkColorTransferFunction* const color = property->GetLabelColor(label);
    sentences.insert(color ? MissingFeatures(color) : "");
    for (vtkPiecewiseFunction* const curve :
      { property->GetLabelScalarOpacity(label), property->GetLabelGradientOpacity(label) })
    {
      sentences.insert(curve ? MissingFeatures(curve) : "");
    }
  }
  return std::accumulate(sentences.begin(), sentences.end(), std::string());
}

Fingerprint TransferFunctionInputs(vtkVolumeProperty* property, int component)
{
  const bool isGray = property->GetColorChannels(component) == 1;
  if (!isGray)
  {
    // A function with a table of colours makes it when it is asked for one, and is newer then.
    property->GetRGBTransferFunction(component)->Build();
  }
  vtkObject* const color = isGray
    ? static_cast<vtkObject*>(property->GetGrayTransferFunction(component))
    : property->GetRGBTransferFunction(component);
  vtkPiecewiseFunction* const opacity = property->GetScalarOpacity(component);
  return Fingerprint(color, color->GetMTime(), opacity, opacity->GetMTime(),
    property->GetScalarOpacityUnitDistance(component));
}

namespace
{

// True for the straight function from 0 to 1024 that VTK makes for a component without one.
bool IsDefault(vtkPiecewiseFunction* function, double first)
{
  double left[4];
  double right[4];
  return function->GetSize() == 2 && function->GetNodeValue(0, left) == 1 &&
    function->GetNodeValue(1, right) == 1 && left[0] == 0.0 && left[1] == first &&
    right[0] == 1024.0 && right[1] == 1.0;
}

bool HasColors(vtkVolumeProperty* property, int component)
{
  return property->GetColorChannels(component) != 1 ||
    !IsDefault(property->GetGrayTransferFunction(component), 0.0);
}

}

bool HasOpacities(vtkVolumeProperty* property, int component)
{
  return !IsDefault(property->GetScalarOpacity(component), 1.0);
}

TransferFunction FunctionOfComponent(
  vtkVolumeProperty* property, int component, const TransferFunction& first)
{
  const TransferFunction own = TransferFunctionOf(property, component);
  const TransferFunction& opacities = HasOpacities(property, component) ? own : first;
  return { HasColors(property, component) ? own.Colors() : first.Colors(), opacities.Opacities(),
    opacities.OpacityUnitDistanceMm() };
}

}
