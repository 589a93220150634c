#include "Viewer/TransferFunctionEditor/EditorPainter.h"

#include <QCoreApplication>
#include <QImage>
#include <QLocale>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace varimarch
{

namespace
{

constexpr double PointRadius = 5.5;
constexpr double TickDistance = 64.0;
// Logarithmic counts show three decades; with more, every value would look frequent.
constexpr double Contrast = 1000.0;

/// A count that only 3 % of the bars exceed. Air, the bulk of many scans, must not flatten the
/// rest.
double LargestShown(const std::vector<HistogramBars::Bar>& bars)
{
  std::vector<double> counts;
  for (const HistogramBars::Bar& bar : bars)
  {
    if (bar.count > 0)
    {
      counts.push_back(double(bar.count));
    }
  }
  if (counts.empty())
  {
    return 1.0;
  }
  const auto nearLargest = counts.begin() + std::ptrdiff_t(0.97 * double(counts.size() - 1));
  std::nth_element(counts.begin(), nearLargest, counts.end());
  return *nearLargest;
}

}

QColor QColorOf(const glm::dvec3& rgb)
{
  return QColor::fromRgbF(
    std::clamp(rgb.r, 0.0, 1.0), std::clamp(rgb.g, 0.0, 1.0), std::clamp(rgb.b, 0.0, 1.0));
}

EditorPainter::EditorPainter(
  QPainter* painter, const EditorPicture& picture, const QPalette& palette)
  : painter(painter)
  , picture(picture)
  , layout(picture.layout)
  , palette(palette)
  , function(FunctionOf(picture.look))
{
}

void EditorPainter::Paint()
{
  this->painter->setRenderHint(QPainter::Antialiasing);
  this->painter->fillRect(this->layout.plot, this->palette.base());
  this->PaintGrid();
  this->painter->save();
  this->painter->setClipRect(this->layout.plot);
  this->PaintHistogram();
  this->painter->restore();
  if (this->picture.look.blend != Blend::Isosurface)
  {
    this->PaintColors();
    this->painter->save();
    this->painter->setClipRect(this->layout.plot.adjusted(0.0, -2.0, 0.0, 2.0));
    this->PaintCurve();
    this->painter->restore();
    this->PaintTies();
  }
  this->PaintTicks();
  this->PaintNodes();
  if (!this->picture.rubberBand.isNull())
  {
    QColor fill = this->palette.color(QPalette::Highlight);
    this->painter->setPen(fill);
    fill.setAlphaF(0.2);
    this->painter->setBrush(fill);
    this->painter->drawRect(this->picture.rubberBand);
  }
  this->PaintReading();
}

void EditorPainter::PaintNodes()
{
  // The margin keeps points at the ends of the axis whole.
  this->painter->setClipRect(QRectF(this->layout.plot.topLeft(), this->layout.stops.bottomRight())
                               .adjusted(-8.0, -9.0, 8.0, 4.0));
  const NodeSet nodes = AllNodes(this->picture.look);
  // Nodes that are grabbed first are painted last, on top.
  for (auto node = nodes.rbegin(); node != nodes.rend(); ++node)
  {
    if (node->kind == NodeKind::Color)
    {
      this->PaintStop(*node);
    }
    else
    {
      this->PaintPoint(*node);
    }
  }
  this->painter->setClipping(false);
}

QColor EditorPainter::Ink(double strength) const
{
  QColor ink = this->palette.color(QPalette::Text);
  ink.setAlphaF(strength);
  return ink;
}

void EditorPainter::PaintHistogram()
{
  if (!this->picture.statistics)
  {
    return;
  }
  const ValueAxis& axis = this->layout.axis;
  const HistogramBars bars(*this->picture.statistics, BarPixels * axis.ValuePerPixel());
  const std::vector<HistogramBars::Bar> shown = bars.Between(axis.First(), axis.Last());
  if (shown.empty())
  {
    return;
  }
  const double largest = LargestShown(shown);
  const QRectF& plot = this->layout.plot;
  QPainterPath outline(QPointF(axis.ToPixel(shown.front().first), plot.bottom()));
  for (const HistogramBars::Bar& bar : shown)
  {
    const double part = double(bar.count) / largest;
    const double height =
      this->picture.logarithmicCounts ? std::log1p(part * Contrast) / std::log1p(Contrast) : part;
    // Scale to slightly below the top, so that clipped bars differ from the tallest one shown
    // whole.
    const double y = plot.bottom() - std::min(0.92 * height, 1.0) * plot.height();
    outline.lineTo(axis.ToPixel(bar.first), y);
    outline.lineTo(axis.ToPixel(bar.last), y);
  }
  outline.lineTo(axis.ToPixel(shown.back().last), plot.bottom());
  this->painter->fillPath(outline, this->Ink(0.18));
  this->painter->setPen(QPen(this->Ink(0.30), 1.0));
  this->painter->setBrush(Qt::NoBrush);
  this->painter->drawPath(outline);
}

void EditorPainter::PaintGrid()
{
  static const double even[] = { 0.0, 0.25, 0.5, 0.75, 1.0 };
  static const double enlarged[] = { 0.0, 0.01, 0.05, 0.2, 0.5, 1.0 };
  const bool low = this->layout.lowOpacitiesEnlarged;
  const QRectF& plot = this->layout.plot;
  const double lineHeight = this->painter->fontMetrics().height();
  for (const double* opacity = low ? std::begin(enlarged) : std::begin(even);
       opacity != (low ? std::end(enlarged) : std::end(even)); ++opacity)
  {
    const double y = this->layout.ToY(*opacity);
    this->painter->setPen(QPen(this->Ink(0.12), 1.0));
    this->painter->drawLine(QPointF(plot.left(), y), QPointF(plot.right(), y));
    this->painter->setPen(this->Ink(0.65));
    this->painter->drawText(QRectF(0.0, y - 0.5 * lineHeight, plot.left() - 6.0, lineHeight),
      Qt::AlignRight | Qt::AlignVCenter, QLocale().toString(*opacity));
  }
}

void EditorPainter::PaintTicks()
{
  const ValueAxis& axis = this->layout.axis;
  const QRectF& row = this->layout.ticks;
  const double unitWidth = this->painter->fontMetrics().horizontalAdvance(this->picture.unit) + 8.0;
  this->painter->setPen(this->Ink(0.65));
  this->painter->drawText(
    row.adjusted(0.0, 2.0, 0.0, 0.0), Qt::AlignRight | Qt::AlignVCenter, this->picture.unit);
  const std::vector<double> ticks = axis.Ticks(TickDistance);
  const double step = ticks.size() > 1 ? ticks[1] - ticks[0] : 1.0;
  const int decimals = std::max(0, int(std::ceil(-std::log10(step) - 1e-9)));
  for (const double tick : ticks)
  {
    const double x = axis.ToPixel(tick);
    this->painter->drawLine(QPointF(x, row.top()), QPointF(x, row.top() + 4.0));
    const QRectF box(x - 0.5 * TickDistance, row.top() + 2.0, TickDistance, row.height() - 2.0);
    const QString text = QLocale().toString(tick, 'f', decimals);
    if (x + 0.5 * this->painter->fontMetrics().horizontalAdvance(text) < row.right() - unitWidth)
    {
      this->painter->drawText(box, Qt::AlignCenter, text);
    }
  }
}

// Paints the colours as a bar, and paler below the curve.
void EditorPainter::PaintColors()
{
  const QRectF& bar = this->layout.colorBar;
  QImage colors(std::max(int(bar.width()), 1), 1, QImage::Format_RGB32);
  QPainterPath below(QPointF(bar.left(), this->layout.plot.bottom()));
  for (int i = 0; i < colors.width(); ++i)
  {
    const double x = bar.left() + (i + 0.5) * bar.width() / colors.width();
    const double value = this->layout.axis.ToValue(x);
    colors.setPixelColor(i, 0, QColorOf(this->function.Color(value)));
    below.lineTo(x, this->layout.ToY(this->function.Opacity(value)));
  }
  below.lineTo(bar.right(), this->layout.plot.bottom());
  if (this->layout.hasColors)
  {
    this->painter->drawImage(bar, colors);
    this->painter->setPen(QPen(this->Ink(0.3), 1.0));
    this->painter->setBrush(Qt::NoBrush);
    this->painter->drawRect(bar);
  }

  this->painter->save();
  this->painter->setClipPath(below);
  this->painter->setOpacity(0.5);
  this->painter->drawImage(this->layout.plot, colors);
  this->painter->restore();
}

// Paints the curve as rendered, with midpoints, sharpness and steps.
void EditorPainter::PaintCurve()
{
  const ValueAxis& axis = this->layout.axis;
  std::vector<double> values;
  for (double x = this->layout.plot.left(); x <= this->layout.plot.right(); x += 0.5)
  {
    values.push_back(axis.ToValue(x));
  }
  for (const OpacityNode& node : this->picture.look.opacities)
  {
    values.push_back(node.value);
    values.push_back(std::nextafter(node.value, node.value + 1.0));
  }
  std::sort(values.begin(), values.end());
  QPolygonF curve;
  for (const double value : values)
  {
    curve.append(QPointF(axis.ToPixel(value), this->layout.ToY(this->function.Opacity(value))));
  }
  this->painter->setBrush(Qt::NoBrush);
  this->painter->setPen(QPen(this->palette.color(QPalette::Base), 4.0));
  this->painter->drawPolyline(curve);
  this->painter->setPen(QPen(this->Ink(0.9), 1.8));
  this->painter->drawPolyline(curve);
}

// Connects selected points with the colour stops tied to them.
void EditorPainter::PaintTies()
{
  const NodeSet tied = WithTied(this->picture.look, this->picture.selected);
  this->painter->setPen(QPen(this->Ink(0.45), 1.0, Qt::DotLine));
  for (const NodeId& node : tied)
  {
    const QPointF at = this->layout.PositionOf(this->picture.look, node);
    const bool inside = at.x() >= this->layout.plot.left() && at.x() <= this->layout.plot.right();
    if (node.kind == NodeKind::Opacity && inside)
    {
      this->painter->drawLine(at, QPointF(at.x(), this->layout.stops.top()));
    }
  }
}

QPen EditorPainter::OutlineOf(const NodeId& node) const
{
  return this->picture.selected.count(node) > 0
    ? QPen(this->palette.color(QPalette::Highlight), 3.0)
    : QPen(this->Ink(0.9), 1.5);
}

void EditorPainter::PaintPoint(const NodeId& node)
{
  const QPointF at = this->layout.PositionOf(this->picture.look, node);
  const QColor color = QColorOf(ColorOf(this->picture.look, node));
  if (node.kind == NodeKind::Surface)
  {
    // Draw a post whose height is the opacity of the surface.
    const QPointF foot(at.x(), this->layout.plot.bottom());
    this->painter->setPen(QPen(this->Ink(0.9), 5.0));
    this->painter->drawLine(at, foot);
    this->painter->setPen(QPen(color, 3.0));
    this->painter->drawLine(at, foot);
  }
  this->painter->setPen(QPen(this->palette.color(QPalette::Base), 5.0));
  this->painter->drawEllipse(at, PointRadius, PointRadius);
  this->painter->setPen(this->OutlineOf(node));
  this->painter->setBrush(color);
  this->painter->drawEllipse(at, PointRadius, PointRadius);
  if (this->picture.focused == node)
  {
    this->painter->setPen(QPen(this->Ink(0.9), 1.0, Qt::DotLine));
    this->painter->setBrush(Qt::NoBrush);
    this->painter->drawEllipse(at, PointRadius + 4.0, PointRadius + 4.0);
  }
}

void EditorPainter::PaintStop(const NodeId& node)
{
  const double x = this->layout.PositionOf(this->picture.look, node).x();
  const double top = this->layout.stops.top() + 1.0;
  const QPolygonF marker({ { x, top }, { x + 5.0, top + 5.0 }, { x + 5.0, top + 12.0 },
    { x - 5.0, top + 12.0 }, { x - 5.0, top + 5.0 } });
  QPen outline = this->OutlineOf(node);
  outline.setWidthF(this->picture.selected.count(node) > 0 ? 2.5 : 1.0);
  this->painter->setPen(outline);
  this->painter->setBrush(QColorOf(this->picture.look.colors[node.index].rgb));
  this->painter->drawPolygon(marker);
  if (this->picture.focused == node)
  {
    this->painter->setPen(QPen(this->Ink(0.9), 1.0, Qt::DotLine));
    this->painter->setBrush(Qt::NoBrush);
    this->painter->drawRect(marker.boundingRect().adjusted(-3.0, -3.0, 3.0, 3.0));
  }
}

void EditorPainter::PaintReading()
{
  const QRectF& plot = this->layout.plot;
  if (!this->picture.pointer)
  {
    return;
  }
  const double x = this->picture.pointer->x();
  this->painter->setPen(QPen(this->Ink(0.35), 1.0));
  this->painter->drawLine(QPointF(x, plot.top()), QPointF(x, this->layout.colorBar.bottom()));

  this->painter->setPen(this->Ink(0.95));
  this->painter->drawText(this->layout.reading, Qt::AlignLeft | Qt::AlignBottom | Qt::TextWordWrap,
    this->picture.reading);
}

namespace
{

// A class, since lupdate finds only the texts that are arguments of tr.
class ReadingTexts
{
  Q_DECLARE_TR_FUNCTIONS(TransferFunctionEditor)
};

QString ValueText(const EditorPicture& picture, double value)
{
  const int decimals = picture.layout.axis.Decimals();
  return picture.unit + ' ' + QLocale().toString(value, 'f', decimals);
}

QString OpacityText(double opacity)
{
  return ReadingTexts::tr("opacity %1")
    .arg(QLocale().toString(opacity, 'f', opacity < 0.1 ? 3 : 2));
}

QString PercentText(double part)
{
  const double percent = 100.0 * part;
  if (percent > 0.0 && percent < 0.01)
  {
    return QStringLiteral("< ") + QLocale().toString(0.01, 'f', 2);
  }
  return QLocale().toString(percent, 'f', percent >= 10.0 ? 0 : percent >= 1.0 ? 1 : 2);
}

QString CountsText(const EditorPicture& picture, double value)
{
  const HistogramBars bars(*picture.statistics, BarPixels * picture.layout.axis.ValuePerPixel());
  const std::vector<std::int64_t>& counts = picture.statistics->Counts();
  const double all = double(std::accumulate(counts.begin(), counts.end(), std::int64_t(0)));
  std::int64_t above = 0;
  for (std::size_t bin = 0; bin < counts.size(); ++bin)
  {
    const double binValue = picture.statistics->Smallest() + bin * picture.statistics->BinSpacing();
    above += binValue > value ? counts[bin] : 0;
  }
  return ReadingTexts::tr("%1 % of voxels, %2 % above")
    .arg(PercentText(bars.At(value).count / all), PercentText(above / all));
}

}

QString ReadingAt(const EditorPicture& picture, const QPointF& position)
{
  const std::optional<NodeId> node =
    picture.layout.NodeAt(picture.look, position, picture.selected);
  const double value =
    node ? ValueOf(picture.look, *node) : picture.layout.axis.ToValue(position.x());
  const bool ofNode = node && node->kind != NodeKind::Color;
  QStringList parts{ ValueText(picture, value) };
  if (ofNode || picture.look.blend != Blend::Isosurface)
  {
    parts.append(OpacityText(
      ofNode ? OpacityOf(picture.look, *node) : FunctionOf(picture.look).Opacity(value)));
  }
  if (picture.statistics)
  {
    parts.append(CountsText(picture, value));
  }
  return parts.join(", ");
}

QString DescriptionOf(const EditorPicture& picture, const NodeId& node)
{
  const QString value = ValueText(picture, ValueOf(picture.look, node));
  if (node.kind == NodeKind::Opacity)
  {
    return ReadingTexts::tr("point %1 of %2, %3, %4")
      .arg(node.index + 1)
      .arg(picture.look.opacities.size())
      .arg(value, OpacityText(OpacityOf(picture.look, node)));
  }
  if (node.kind == NodeKind::Surface)
  {
    return ReadingTexts::tr("surface %1 of %2, %3, %4")
      .arg(node.index + 1)
      .arg(picture.look.isosurfaces.size())
      .arg(value, OpacityText(OpacityOf(picture.look, node)));
  }
  return ReadingTexts::tr("colour %1 of %2, %3")
    .arg(node.index + 1)
    .arg(picture.look.colors.size())
    .arg(value);
}

}
