#include "Viewer/TransferFunctionEditor/LookEditing.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace varimarch
{

namespace
{

/// Index range [first, last) of the nodes at a value. The nodes are sorted.
template <class Node>
std::pair<int, int> IndicesAt(const std::vector<Node>& nodes, double value)
{
  const auto below = [](const Node& node, double limit) { return node.value < limit; };
  const auto above = [](double limit, const Node& node) { return limit < node.value; };
  return { int(std::lower_bound(nodes.begin(), nodes.end(), value, below) - nodes.begin()),
    int(std::upper_bound(nodes.begin(), nodes.end(), value, above) - nodes.begin()) };
}

constexpr double Infinity = std::numeric_limits<double>::infinity();

struct Limits
{
  double low = -Infinity;
  double high = Infinity;
};

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

// Templates on the constness of the look.
template <class LookType>
auto& ValueIn(LookType& look, const NodeId& node)
{
  switch (node.kind)
  {
    case NodeKind::Opacity:
      return look.opacities[node.index].value;
    case NodeKind::Color:
      return look.colors[node.index].value;
    default:
      return look.isosurfaces[node.index].value;
  }
}

template <class LookType>
auto& OpacityIn(LookType& look, const NodeId& node)
{
  return node.kind == NodeKind::Surface ? look.isosurfaces[node.index].opacity
                                        : look.opacities[node.index].opacity;
}

template <class Change>
void ChangeValues(Look& look, const NodeSet& nodes, const Change& change)
{
  for (const NodeId& node : nodes)
  {
    double& value = ValueIn(look, node);
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

/// Limits between which the moving nodes stay between the fixed ones, for each value of a moving
/// node. The key is the value, so that tied nodes get bitwise equal limits.
std::map<double, Limits> LimitsOf(const Look& look, const NodeSet& moving)
{
  std::map<double, Limits> limits;
  NarrowLimits(look.opacities, NodeKind::Opacity, moving, limits);
  NarrowLimits(look.colors, NodeKind::Color, moving, limits);
  NarrowLimits(look.isosurfaces, NodeKind::Surface, moving, limits);
  return limits;
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
  if (left.empty() && !nodes.empty())
  {
    left.push_back(nodes.front());
  }
  nodes = std::move(left);
}

/// Keeps the region beyond the ends of a curve transparent where a longer curve was.
void KeepDarkBeyondEnds(
  std::vector<OpacityNode>& nodes, const std::vector<OpacityNode>& longer, double longestRamp)
{
  const OpacityNode first = nodes.front();
  const OpacityNode last = nodes.back();
  if (longer.front().opacity == 0.0 && first.opacity > 0.0)
  {
    const double ramp = std::min(longestRamp, first.value - longer.front().value);
    nodes.insert(nodes.begin(), { first.value - ramp, 0.0 });
  }
  if (longer.back().opacity == 0.0 && last.opacity > 0.0)
  {
    nodes.push_back({ last.value + std::min(longestRamp, longer.back().value - last.value), 0.0 });
  }
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

double ValueOf(const Look& look, const NodeId& node)
{
  return ValueIn(look, node);
}

double OpacityOf(const Look& look, const NodeId& node)
{
  return OpacityIn(look, node);
}

glm::dvec3 ColorOf(const Look& look, const NodeId& node)
{
  if (node.kind == NodeKind::Surface)
  {
    return look.isosurfaces[node.index].rgb;
  }
  // At a step, the tied colour node gives the colour of its side.
  glm::dvec3 rgb = FunctionOf(look).Color(ValueOf(look, node));
  for (const NodeId& tied : WithTied(look, { node }))
  {
    rgb = tied.kind == NodeKind::Color ? look.colors[tied.index].rgb : rgb;
  }
  return rgb;
}

NodeShape ShapeOf(const Look& look, const NodeId& node)
{
  switch (node.kind)
  {
    case NodeKind::Opacity:
      return look.opacities[node.index].shape;
    case NodeKind::Color:
      return look.colors[node.index].shape;
    default:
      return {};
  }
}

bool SameCurves(const Look& a, const Look& b)
{
  const bool sameSurfaces = std::equal(a.isosurfaces.begin(), a.isosurfaces.end(),
    b.isosurfaces.begin(), b.isosurfaces.end(),
    [](const Isosurface& x, const Isosurface& y)
    { return x.value == y.value && x.rgb == y.rgb && x.opacity == y.opacity; });
  return sameSurfaces && (a.blend == Blend::Isosurface) == (b.blend == Blend::Isosurface) &&
    SameNodes(a.opacities, b.opacities,
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
  const auto add = [&](NodeKind kind, std::size_t count)
  {
    for (int i = 0; i < int(count); ++i)
    {
      nodes.insert({ kind, i });
    }
  };
  if (look.blend == Blend::Isosurface)
  {
    add(NodeKind::Surface, look.isosurfaces.size());
    return nodes;
  }
  add(NodeKind::Opacity, look.opacities.size());
  add(NodeKind::Color, look.colors.size());
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
  // Rounding might carry the sum past a limit, and leave the nodes unsorted.
  ChangeValues(changed, moving,
    [&](double value) { return std::clamp(value + shift, limits[value].low, limits[value].high); });
  for (const NodeId& node : nodes)
  {
    if (node.kind != NodeKind::Color)
    {
      double& opacity = OpacityIn(changed, node);
      opacity = std::clamp(opacity + opacityShift, 0.0, 1.0);
    }
  }
  return changed;
}

Look RemoveNodes(const Look& look, const NodeSet& nodes, double longestRamp)
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
  KeepDarkBeyondEnds(changed.opacities, look.opacities, longestRamp);
  EraseNodes(changed.colors, NodeKind::Color, removed);
  EraseNodes(changed.isosurfaces, NodeKind::Surface, removed);
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
  OpacityIn(changed, node) = std::clamp(opacity, 0.0, 1.0);
  return changed;
}

Look SetColor(const Look& look, const NodeId& node, const glm::dvec3& rgb)
{
  Look changed = look;
  if (node.kind == NodeKind::Surface)
  {
    changed.isosurfaces[node.index].rgb = rgb;
    return changed;
  }
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
    const Insertion added = InsertColor(look, ValueOf(look, node));
    changed = added.look;
    changed.colors[added.node.index].rgb = rgb;
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
  ChangeValues(changed, AllNodes(look),
    [=](double value) { return fixedValue + factor * (value - fixedValue); });
  return changed;
}

// The functions of LookEditing that add nodes.

namespace
{

constexpr double Unlimited = std::numeric_limits<double>::infinity();

/// Inserts a node into a curve. If the segment is not linear, its midpoint stays in place, on one
/// side of the new node.
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

Insertion InsertSurface(const Look& look, double value, double opacity)
{
  Look changed = look;
  const int index = IndicesAt(look.isosurfaces, value).second;
  changed.isosurfaces.insert(changed.isosurfaces.begin() + index,
    Isosurface{ value, FunctionOf(look).Color(value), opacity });
  return { changed, { NodeKind::Surface, index } };
}

}

Insertion InsertPoint(const Look& look, double value, double opacity, double longestRamp)
{
  const double possible = std::clamp(opacity, 0.0, 1.0);
  if (look.blend == Blend::Isosurface)
  {
    return InsertSurface(look, value, possible);
  }
  const auto [firstColor, endOfColors] = IndicesAt(look.colors, value);
  const bool needsColor = firstColor == endOfColors && !look.colors.empty();
  Look changed = needsColor ? InsertColor(look, value).look : look;
  int index = InsertNode(changed.opacities, OpacityNode{ value, possible });
  const OpacityNode& first = look.opacities.front();
  const OpacityNode& last = look.opacities.back();
  if (value < first.value && first.opacity == 0.0 && possible > 0.0)
  {
    const double ramp = std::min(longestRamp, first.value - value);
    changed.opacities.insert(changed.opacities.begin(), { value - ramp, 0.0 });
    ++index;
  }
  else if (value > last.value && last.opacity == 0.0 && possible > 0.0)
  {
    changed.opacities.push_back({ value + std::min(longestRamp, value - last.value), 0.0 });
  }
  return { changed, { NodeKind::Opacity, index } };
}

double WithinNeighbors(const Look& look, double between, double value)
{
  const auto [begin, end] = IndicesAt(look.opacities, between);
  const double low = begin > 0 ? look.opacities[begin - 1].value : -Unlimited;
  const double high = end < int(look.opacities.size()) ? look.opacities[end].value : Unlimited;
  return std::clamp(value, low, high);
}

Look WithSurface(const Look& look)
{
  if (!look.isosurfaces.empty())
  {
    return look;
  }
  const auto byOpacity = [](const OpacityNode& a, const OpacityNode& b)
  { return a.opacity < b.opacity; };
  const double half =
    0.5 * std::max_element(look.opacities.begin(), look.opacities.end(), byOpacity)->opacity;
  const auto node = std::find_if(look.opacities.begin(), look.opacities.end(),
    [half](const OpacityNode& candidate) { return candidate.opacity >= half; });
  Look changed = look;
  changed.isosurfaces = { { node->value, FunctionOf(look).Color(node->value), 1.0 } };
  return changed;
}

Insertion InsertColor(const Look& look, double value)
{
  Look changed = look;
  const int index = InsertNode(changed.colors, ColorNode{ value, FunctionOf(look).Color(value) });
  return { changed, { NodeKind::Color, index } };
}

}
