#include "Viewer/TransferFunctionEditor/LookEditing.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace varimarch
{

namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

struct Limits
{
  double low = -Infinity;
  double high = Infinity;
};

template <class Node>
std::pair<int, int> IndicesAt(const std::vector<Node>& nodes, double value)
{
  const auto below = [](const Node& node, double limit) { return node.value < limit; };
  const auto above = [](double limit, const Node& node) { return limit < node.value; };
  return { int(std::lower_bound(nodes.begin(), nodes.end(), value, below) - nodes.begin()),
    int(std::upper_bound(nodes.begin(), nodes.end(), value, above) - nodes.begin()) };
}

/// The opacity node that a colour node is tied to, or -1.
int OwnerOfColor(const Look& look, int color)
{
  const double value = look.colors[color].value;
  const auto [firstOpacity, endOfOpacities] = IndicesAt(look.opacities, value);
  if (firstOpacity == endOfOpacities)
  {
    return -1;
  }
  const int firstColor = IndicesAt(look.colors, value).first;
  return std::min(firstOpacity + color - firstColor, endOfOpacities - 1);
}

template <class Change>
void ChangeValues(Look& look, const NodeSet& nodes, const Change& change)
{
  for (const NodeId& node : nodes)
  {
    double& value = node.kind == NodeKind::Opacity ? look.opacities[node.index].value
                                                   : look.colors[node.index].value;
    value = change(value);
  }
}

template <class Node>
void NarrowLimits(const std::vector<Node>& nodes, NodeKind kind, const NodeSet& moving,
  std::map<double, Limits>& limits)
{
  const auto moves = [&](int index) { return moving.count({ kind, index }) > 0; };
  double low = -Infinity;
  for (int i = 0; i < int(nodes.size()); ++i)
  {
    if (moves(i))
    {
      limits[nodes[i].value].low = std::max(limits[nodes[i].value].low, low);
    }
    else
    {
      low = nodes[i].value;
    }
  }
  double high = Infinity;
  for (int i = int(nodes.size()) - 1; i >= 0; --i)
  {
    if (moves(i))
    {
      limits[nodes[i].value].high = std::min(limits[nodes[i].value].high, high);
    }
    else
    {
      high = nodes[i].value;
    }
  }
}

/// How far the nodes that stay let the others go, for each value that some of them have. By value,
/// so that tied nodes stay tied to the last bit.
std::map<double, Limits> LimitsOf(const Look& look, const NodeSet& moving)
{
  std::map<double, Limits> limits;
  NarrowLimits(look.opacities, NodeKind::Opacity, moving, limits);
  NarrowLimits(look.colors, NodeKind::Color, moving, limits);
  return limits;
}

/// Inserts a node into the curve. A segment that is not straight keeps its bend where it was, on
/// one side of the new node.
template <class Node>
int InsertNode(std::vector<Node>& nodes, Node inserted)
{
  const int index = IndicesAt(nodes, inserted.value).second;
  if (index > 0 && index < int(nodes.size()))
  {
    Node& left = nodes[index - 1];
    const double right = nodes[index].value;
    const NodeShape straight;
    const NodeShape shape = left.shape;
    if (shape.midpoint != straight.midpoint || shape.sharpness != straight.sharpness)
    {
      const double halfWay = HalfWayValue(left.value, right, shape);
      Node& bent = halfWay < inserted.value ? left : inserted;
      const double end = halfWay < inserted.value ? inserted.value : right;
      left.shape = straight;
      bent.shape = { (halfWay - bent.value) / (end - bent.value), shape.sharpness };
    }
  }
  nodes.insert(nodes.begin() + index, inserted);
  return index;
}

template <class Node>
void EraseNodes(std::vector<Node>& nodes, NodeKind kind, const NodeSet& removed)
{
  std::vector<Node> left;
  for (int i = 0; i < int(nodes.size()); ++i)
  {
    if (removed.count({ kind, i }) == 0)
    {
      left.push_back(nodes[i]);
    }
  }
  if (left.empty())
  {
    left.push_back(nodes.front());
  }
  nodes = std::move(left);
}

template <class Node, class SameOrdinate>
bool SameNodes(const std::vector<Node>& a, const std::vector<Node>& b, SameOrdinate sameOrdinate)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
    [&](const Node& x, const Node& y)
    {
      return x.value == y.value && x.shape.midpoint == y.shape.midpoint &&
        x.shape.sharpness == y.shape.sharpness && sameOrdinate(x, y);
    });
}

}

bool Exists(const Look& look, const NodeId& node)
{
  const std::size_t count =
    node.kind == NodeKind::Opacity ? look.opacities.size() : look.colors.size();
  return node.index >= 0 && node.index < int(count);
}

double ValueOf(const Look& look, const NodeId& node)
{
  return node.kind == NodeKind::Opacity ? look.opacities[node.index].value
                                        : look.colors[node.index].value;
}

NodeShape ShapeOf(const Look& look, const NodeId& node)
{
  return node.kind == NodeKind::Opacity ? look.opacities[node.index].shape
                                        : look.colors[node.index].shape;
}

bool SameCurves(const Look& a, const Look& b)
{
  return SameNodes(a.opacities, b.opacities,
           [](const OpacityNode& x, const OpacityNode& y) { return x.opacity == y.opacity; }) &&
    SameNodes(
      a.colors, b.colors, [](const ColorNode& x, const ColorNode& y) { return x.rgb == y.rgb; });
}

TransferFunction FunctionOf(const Look& look)
{
  return TransferFunction(look.colors, look.opacities, look.opacityUnitDistanceMm);
}

NodeSet AllNodes(const Look& look)
{
  NodeSet nodes;
  for (int i = 0; i < int(look.opacities.size()); ++i)
  {
    nodes.insert({ NodeKind::Opacity, i });
  }
  for (int i = 0; i < int(look.colors.size()); ++i)
  {
    nodes.insert({ NodeKind::Color, i });
  }
  return nodes;
}

NodeSet WithTied(const Look& look, const NodeSet& nodes)
{
  NodeSet tied = nodes;
  for (const NodeId& node : nodes)
  {
    if (node.kind == NodeKind::Color && OwnerOfColor(look, node.index) >= 0)
    {
      tied.insert({ NodeKind::Opacity, OwnerOfColor(look, node.index) });
    }
  }
  for (int color = 0; color < int(look.colors.size()); ++color)
  {
    if (tied.count({ NodeKind::Opacity, OwnerOfColor(look, color) }) > 0)
    {
      tied.insert({ NodeKind::Color, color });
    }
  }
  return tied;
}

Insertion InsertPoint(const Look& look, double value, double opacity)
{
  const auto [firstColor, endOfColors] = IndicesAt(look.colors, value);
  Look changed = firstColor == endOfColors ? InsertColor(look, value).look : look;
  const int index =
    InsertNode(changed.opacities, OpacityNode{ value, std::clamp(opacity, 0.0, 1.0) });
  return { changed, { NodeKind::Opacity, index } };
}

Insertion InsertColor(const Look& look, double value)
{
  Look changed = look;
  const int index = InsertNode(changed.colors, ColorNode{ value, FunctionOf(look).Color(value) });
  return { changed, { NodeKind::Color, index } };
}

Look MoveNodes(const Look& look, const NodeSet& nodes, double valueShift, double opacityShift)
{
  Look changed = look;
  const NodeSet moving = WithTied(look, nodes);
  std::map<double, Limits> limits = LimitsOf(look, moving);
  double shift = valueShift;
  for (const auto& [value, limit] : limits)
  {
    shift = std::clamp(shift, std::min(0.0, limit.low - value), std::max(0.0, limit.high - value));
  }
  // Rounded sums might pass a limit by a bit, and the nodes would not be sorted.
  ChangeValues(changed, moving,
    [&](double value) { return std::clamp(value + shift, limits[value].low, limits[value].high); });
  for (const NodeId& node : nodes)
  {
    if (node.kind == NodeKind::Opacity)
    {
      double& opacity = changed.opacities[node.index].opacity;
      opacity = std::clamp(opacity + opacityShift, 0.0, 1.0);
    }
  }
  return changed;
}

Look RemoveNodes(const Look& look, const NodeSet& nodes)
{
  NodeSet removed = nodes;
  for (int color = 0; color < int(look.colors.size()); ++color)
  {
    if (nodes.count({ NodeKind::Opacity, OwnerOfColor(look, color) }) > 0)
    {
      removed.insert({ NodeKind::Color, color });
    }
  }
  Look changed = look;
  EraseNodes(changed.opacities, NodeKind::Opacity, removed);
  EraseNodes(changed.colors, NodeKind::Color, removed);
  return changed;
}

Look SetValue(const Look& look, const NodeId& node, double value)
{
  Look changed = look;
  const NodeSet moving = WithTied(look, { node });
  const Limits limits = LimitsOf(look, moving)[ValueOf(look, node)];
  const double nearest = std::clamp(value, limits.low, limits.high);
  ChangeValues(changed, moving, [nearest](double) { return nearest; });
  return changed;
}

Look SetOpacity(const Look& look, const NodeId& node, double opacity)
{
  Look changed = look;
  changed.opacities[node.index].opacity = std::clamp(opacity, 0.0, 1.0);
  return changed;
}

Look SetColor(const Look& look, const NodeId& node, const glm::dvec3& rgb)
{
  Look changed = look;
  const NodeSet tied = node.kind == NodeKind::Color ? NodeSet{ node } : WithTied(look, { node });
  bool hasColor = false;
  for (const NodeId& color : tied)
  {
    if (color.kind == NodeKind::Color)
    {
      changed.colors[color.index].rgb = rgb;
      hasColor = true;
    }
  }
  if (!hasColor)
  {
    InsertNode(changed.colors, ColorNode{ ValueOf(look, node), rgb });
  }
  return changed;
}

Look SetShape(const Look& look, const NodeId& node, const NodeShape& shape)
{
  Look changed = look;
  (node.kind == NodeKind::Opacity ? changed.opacities[node.index].shape
                                  : changed.colors[node.index].shape) = shape;
  return changed;
}

Look ScaleLook(const Look& look, double factor, double fixedValue)
{
  Look changed = look;
  for (OpacityNode& node : changed.opacities)
  {
    node.value = fixedValue + factor * (node.value - fixedValue);
  }
  for (ColorNode& node : changed.colors)
  {
    node.value = fixedValue + factor * (node.value - fixedValue);
  }
  return changed;
}

}
