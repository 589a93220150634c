#include "Frame/CurveNodes.h"

#include "Frame/CurveSampling.h"

#include "vtkColorTransferFunction.h"
#include "vtkDiscretizableColorTransferFunction.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>

namespace varimarch
{

namespace
{

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

}

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
