#include "Viewer/RegionEditor/RegionPainter.h"

#include "Scene/Looks/LookRegions.h"
#include "Viewer/TransferFunctionEditor/EditorPainter.h"

#include <QLocale>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

constexpr double HandleReach = 7.0; // [pixels]

// Moves one end of an interval, or both for 0, within limits.
std::array<double, 2> DragInterval(std::array<double, 2> interval, int handle, double shift,
  const std::array<double, 2>& limits, double leastWidth)
{
  if (handle < 0)
  {
    interval[0] = std::clamp(interval[0] + shift, std::min(limits[0], interval[0]),
      std::max(interval[1] - leastWidth, limits[0]));
  }
  else if (handle > 0)
  {
    interval[1] = std::clamp(interval[1] + shift, std::min(interval[0] + leastWidth, limits[1]),
      std::max(limits[1], interval[1]));
  }
  else
  {
    const double lowest = std::min(limits[0] - interval[0], 0.0);
    const double highest = std::max(limits[1] - interval[1], 0.0);
    const double moved = std::clamp(shift, lowest, highest);
    interval = { interval[0] + moved, interval[1] + moved };
  }
  return interval;
}

}

LookRegion DragRegion(const LookRegion& region, RegionHandle handle, double valueShift,
  double gradientShift, const RegionPlane& plane)
{
  LookRegion dragged = region;
  const bool moves = handle.value == 0 && handle.gradient == 0;
  if (moves || handle.value != 0)
  {
    dragged.values =
      DragInterval(region.values, handle.value, valueShift, plane.values, plane.LeastValueWidth());
  }
  if (moves || handle.gradient != 0)
  {
    dragged.gradients = DragInterval(region.gradients, handle.gradient, gradientShift,
      { 0.0, plane.largestGradient }, plane.LeastGradientWidth());
  }
  return dragged;
}

LookRegion NewRegion(RegionShape shape, double value, double gradient,
  std::array<double, 2> visibleWidths, const RegionPlane& plane)
{
  constexpr double Part = 1.0 / 7.0;
  const double halfValues = Part * visibleWidths[0];
  const double halfGradients = Part * visibleWidths[1];
  LookRegion region;
  region.shape = shape;
  region.values = { value - halfValues, value + halfValues };
  region.gradients = { std::max(gradient - halfGradients, 0.0), gradient + halfGradients };
  region.rgb = { 1.0, 0.85, 0.6 };
  // Moves it into the plane.
  const double right = std::max(plane.values[0] - region.values[0], 0.0);
  const double left = std::min(plane.values[1] - region.values[1], 0.0);
  region.values = { region.values[0] + right + left, region.values[1] + right + left };
  region.gradients[1] = std::min(region.gradients[1],
    std::max(plane.largestGradient, region.gradients[0] + plane.LeastGradientWidth()));
  return region;
}

void RegionLayout::Resize(const QSizeF& size, double lineHeight, double gradientTextWidth)
{
  constexpr double Margin = 8.0;
  const double left = gradientTextWidth + Margin;
  this->reading = QRectF(left, 0.0, size.width() - left - Margin, lineHeight);
  const double top = lineHeight + 4.0;
  const double bottom = size.height() - lineHeight - 8.0;
  this->plot =
    QRectF(left, top, std::max(size.width() - left - Margin, 1.0), std::max(bottom - top, 1.0));
  this->ticks = QRectF(left, bottom, this->plot.width(), size.height() - bottom);
  this->values.SetPixels(this->plot.left(), this->plot.right());
  this->gradients.SetPixels(0.0, this->plot.height());
}

QPointF RegionLayout::ToPoint(double value, double gradient) const
{
  return { this->values.ToPixel(value), this->plot.bottom() - this->gradients.ToPixel(gradient) };
}

QRectF RegionLayout::RectOf(const LookRegion& region) const
{
  return { this->ToPoint(region.values[0], region.gradients[1]),
    this->ToPoint(region.values[1], region.gradients[0]) };
}

std::vector<RegionHandle> HandlesOfRegion()
{
  return { { -1, -1 }, { -1, 1 }, { 1, -1 }, { 1, 1 }, { -1, 0 }, { 1, 0 }, { 0, -1 }, { 0, 1 } };
}

QPointF PlaceOfHandle(const QRectF& rect, RegionHandle handle)
{
  return rect.center() +
    QPointF(0.5 * handle.value * rect.width(), -0.5 * handle.gradient * rect.height());
}

std::optional<RegionHandle> RegionLayout::HandleAt(
  const LookRegion& region, const QPointF& position) const
{
  const QRectF rect = this->RectOf(region);
  std::optional<RegionHandle> found;
  double nearest = HandleReach;
  for (const RegionHandle handle : HandlesOfRegion())
  {
    const QPointF way = position - PlaceOfHandle(rect, handle);
    const double distance = std::hypot(way.x(), way.y());
    if (distance < nearest)
    {
      found = handle;
      nearest = distance;
    }
  }
  return found;
}

std::optional<int> RegionLayout::RegionAt(
  const std::vector<LookRegion>& regions, const QPointF& position, int preferred) const
{
  const double value = this->ToValue(position.x());
  const double gradient = this->ToGradient(position.y());
  std::optional<int> found;
  for (int i = 0; i < int(regions.size()); ++i)
  {
    const bool isInside =
      gradient >= regions[i].gradients[0] && PlaceInRegion(regions[i], value, gradient) <= 1.0;
    if (isInside && found != preferred)
    {
      found = i;
    }
  }
  return found;
}

namespace
{

constexpr double ValueTickDistance = 64.0;
constexpr double GradientTickDistance = 32.0;
constexpr double HandlePixels = 7.0;

QColor InkOf(const QPalette& palette, double strength)
{
  QColor ink = palette.color(QPalette::Text);
  ink.setAlphaF(strength);
  return ink;
}

QString TickText(double tick, const std::vector<double>& ticks)
{
  const double step = ticks.size() > 1 ? ticks[1] - ticks[0] : 1.0;
  return QLocale().toString(tick, 'f', std::max(0, int(std::ceil(-std::log10(step) - 1e-9))));
}

QPainterPath OutlineOfRegion(const LookRegion& region, const QRectF& rect)
{
  QPainterPath path;
  if (region.shape == RegionShape::Ellipse)
  {
    path.addEllipse(rect);
  }
  else
  {
    path.addRect(rect);
  }
  return path;
}

// The rectangle within which a region has its whole opacity.
QRectF FirmPart(const LookRegion& region, const QRectF& rect)
{
  const double part = 1.0 - region.softness;
  QRectF firm(0.0, 0.0, part * rect.width(), part * rect.height());
  firm.moveCenter(rect.center());
  if (region.shape == RegionShape::Rectangle && region.gradients[0] <= 0.0)
  {
    firm.setTop(rect.bottom() - part * rect.height());
    firm.setBottom(rect.bottom());
  }
  return firm;
}

void PaintCounts(QPainter& painter, const RegionPicture& picture)
{
  if (picture.counts.isNull())
  {
    return;
  }
  const ValueGradientHistogram& histogram = *picture.histogram;
  const QRectF whole(picture.layout.ToPoint(histogram.values[0], histogram.largestGradient),
    picture.layout.ToPoint(histogram.values[1], 0.0));
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(whole, picture.counts);
}

void PaintRegion(
  QPainter& painter, const RegionPicture& picture, int index, const QPalette& palette)
{
  const LookRegion& region = picture.regions[std::size_t(index)];
  const QRectF rect = picture.layout.RectOf(region);
  const bool isSelected = index == picture.selected;
  QColor fill = QColorOf(region.rgb);
  fill.setAlphaF(0.15 + 0.5 * region.opacity);
  painter.fillPath(OutlineOfRegion(region, FirmPart(region, rect)), fill);
  fill.setAlphaF(0.4 * fill.alphaF());
  painter.fillPath(OutlineOfRegion(region, rect), fill);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(palette.color(QPalette::Base), 4.0));
  painter.drawPath(OutlineOfRegion(region, rect));
  painter.setPen(
    isSelected ? QPen(palette.color(QPalette::Highlight), 2.5) : QPen(InkOf(palette, 0.9), 1.5));
  painter.drawPath(OutlineOfRegion(region, rect));
  painter.setPen(QPen(InkOf(palette, 0.6), 1.0, Qt::DotLine));
  painter.drawPath(OutlineOfRegion(region, FirmPart(region, rect)));
}

void PaintHandles(QPainter& painter, const RegionPicture& picture, const QPalette& palette)
{
  if (picture.selected < 0)
  {
    return;
  }
  const QRectF rect = picture.layout.RectOf(picture.regions[std::size_t(picture.selected)]);
  painter.setPen(QPen(InkOf(palette, 0.9), 1.0));
  painter.setBrush(palette.color(QPalette::Highlight));
  for (const RegionHandle handle : HandlesOfRegion())
  {
    QRectF square(0.0, 0.0, HandlePixels, HandlePixels);
    square.moveCenter(PlaceOfHandle(rect, handle));
    painter.drawRect(square);
  }
  if (picture.hasFocus)
  {
    painter.setPen(QPen(InkOf(palette, 0.9), 1.0, Qt::DotLine));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(rect.adjusted(-6.0, -6.0, 6.0, 6.0));
  }
}

void PaintRegionTicks(QPainter& painter, const RegionPicture& picture, const QPalette& palette)
{
  const RegionLayout& layout = picture.layout;
  const double lineHeight = painter.fontMetrics().height();
  painter.setPen(InkOf(palette, 0.65));
  const std::vector<double> values = layout.values.Ticks(ValueTickDistance);
  for (const double tick : values)
  {
    const double x = layout.values.ToPixel(tick);
    painter.drawLine(QPointF(x, layout.ticks.top()), QPointF(x, layout.ticks.top() + 4.0));
    painter.drawText(
      QRectF(x - 0.5 * ValueTickDistance, layout.ticks.top() + 4.0, ValueTickDistance, lineHeight),
      Qt::AlignCenter, TickText(tick, values));
  }
  const std::vector<double> gradients = layout.gradients.Ticks(GradientTickDistance);
  for (const double tick : gradients)
  {
    const double y = layout.plot.bottom() - layout.gradients.ToPixel(tick);
    painter.drawLine(QPointF(layout.plot.left() - 4.0, y), QPointF(layout.plot.left(), y));
    painter.drawText(QRectF(0.0, y - 0.5 * lineHeight, layout.plot.left() - 6.0, lineHeight),
      Qt::AlignRight | Qt::AlignVCenter, TickText(tick, gradients));
  }
}

}

QImage PictureOfCounts(const ValueGradientHistogram& histogram, const QColor& ink)
{
  constexpr int Columns = ValueGradientHistogram::Columns;
  constexpr int Rows = ValueGradientHistogram::Rows;
  constexpr double Strongest = 0.85;
  const double largest =
    double(*std::max_element(histogram.counts.begin(), histogram.counts.end()));
  QImage image(Columns, Rows, QImage::Format_ARGB32);
  for (int row = 0; row < Rows; ++row)
  {
    auto* const pixels = reinterpret_cast<QRgb*>(image.scanLine(Rows - 1 - row));
    for (int column = 0; column < Columns; ++column)
    {
      const double count = double(histogram.counts[std::size_t(row) * Columns + column]);
      const double strength = largest > 0.0 ? std::log1p(count) / std::log1p(largest) : 0.0;
      pixels[column] = qRgba(ink.red(), ink.green(), ink.blue(), int(255.0 * Strongest * strength));
    }
  }
  return image;
}

void PaintRegions(QPainter& painter, const RegionPicture& picture, const QPalette& palette)
{
  painter.fillRect(picture.layout.plot, palette.base());
  painter.setClipRect(picture.layout.plot);
  PaintCounts(painter, picture);
  painter.setRenderHint(QPainter::Antialiasing);
  for (int i = 0; i < int(picture.regions.size()); ++i)
  {
    PaintRegion(painter, picture, i, palette);
  }
  painter.setClipRect(picture.layout.plot.adjusted(-8.0, -8.0, 8.0, 8.0));
  PaintHandles(painter, picture, palette);
  painter.setClipping(false);
  PaintRegionTicks(painter, picture, palette);
  painter.setPen(InkOf(palette, 0.95));
  painter.drawText(picture.layout.reading, Qt::AlignLeft | Qt::AlignVCenter, picture.reading);
}

}
