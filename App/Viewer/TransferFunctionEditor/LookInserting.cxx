// The functions of LookEditing that add nodes.

#include "Viewer/TransferFunctionEditor/LookEditing.h"
#include "Viewer/TransferFunctionEditor/NodeIndices.h"

#include <algorithm>
#include <limits>

namespace varimarch
{

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
