#include "Viewer/TransferFunctionEditor/EditorLayout.h"

#include <QLineF>

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

constexpr double Margin = 10.0;
constexpr double BarHeight = 16.0;
constexpr double StopHeight = 14.0;
constexpr double Reach = 9.0;
constexpr double CurveReach = 5.0;

}

void EditorLayout::Resize(const QSizeF& size, const QFontMetricsF& font)
{
  const double left = Margin + font.horizontalAdvance("0.05") + 6.0;
  const double right = size.width() - Margin;
  const double ticksHeight = font.height() + 8.0;
  const double barHeight = this->hasColors ? BarHeight : 0.0;
  const double stopHeight = this->hasColors ? StopHeight : 0.0;
  const double below = barHeight + stopHeight + ticksHeight + 4.0;
  // The text takes two lines in a narrow panel.
  this->reading = QRectF(left, 0.0, right - left, 2.0 * font.height() + 2.0);
  const double top = this->reading.bottom() + 0.5 * Margin;
  this->plot =
    QRectF(left, top, std::max(right - left, 1.0), std::max(size.height() - top - below, 1.0));
  this->ticks = QRectF(left, this->plot.bottom(), this->plot.width(), ticksHeight);
  this->colorBar = QRectF(left, this->ticks.bottom(), this->plot.width(), barHeight);
  this->stops = QRectF(left, this->colorBar.bottom(), this->plot.width(), stopHeight);
  this->axis.SetPixels(this->plot.left(), this->plot.right());
}

double EditorLayout::ToY(double opacity) const
{
  const double height = this->lowOpacitiesEnlarged ? std::sqrt(opacity) : opacity;
  return this->plot.bottom() - height * this->plot.height();
}

double EditorLayout::ToOpacity(double y) const
{
  const double height = std::clamp((this->plot.bottom() - y) / this->plot.height(), 0.0, 1.0);
  return this->lowOpacitiesEnlarged ? height * height : height;
}

QPointF EditorLayout::PositionOf(const Look& look, const NodeId& node) const
{
  const double x = this->axis.ToPixel(ValueOf(look, node));
  return node.kind == NodeKind::Color ? QPointF(x, this->stops.top() + 0.5 * StopHeight)
                                      : QPointF(x, this->ToY(OpacityOf(look, node)));
}

std::optional<NodeId> EditorLayout::NodeAt(
  const Look& look, const QPointF& position, const NodeSet& preferred) const
{
  std::optional<NodeId> nearest;
  double least = Reach;
  const auto consider = [&](const NodeId& node)
  {
    const QPointF at = this->PositionOf(look, node);
    // A bonus for preferred nodes, so that they win at the same place.
    const double distance = QLineF(at, position).length() - (preferred.count(node) > 0 ? 1.0 : 0.0);
    if (at.x() >= this->plot.left() - 1.0 && at.x() <= this->plot.right() + 1.0 &&
      distance <= least)
    {
      nearest = node;
      least = distance;
    }
  };
  for (const NodeId& node : AllNodes(look))
  {
    consider(node);
  }
  return nearest;
}

bool EditorLayout::IsOnCurve(const Look& look, const QPointF& position) const
{
  if (look.blend == Blend::Isosurface)
  {
    return false;
  }
  const double y = this->ToY(FunctionOf(look).Opacity(this->axis.ToValue(position.x())));
  return this->plot.contains(position) && std::abs(position.y() - y) <= CurveReach;
}

}
