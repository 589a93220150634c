#include "Viewer/TransferFunctionEditor/EditorLayout.h"

#include <QLineF>

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

constexpr double LeastPartOfData = 1e-4;
constexpr double LargestPartOfData = 4.0;
constexpr double RoomAtTheSides = 0.05;

/// The smallest number of the form 1, 2 or 5 times a power of ten that is at least `width`.
double RoundAtLeast(double width)
{
  const double power = std::pow(10.0, std::floor(std::log10(width)));
  for (const double factor : { 1.0, 2.0, 5.0 })
  {
    if (factor * power >= width)
    {
      return factor * power;
    }
  }
  return 10.0 * power;
}

}

void ValueAxis::SetData(double newSmallest, double newLargest)
{
  this->smallest = newSmallest;
  // A constant volume gets a range of width 1.
  this->largest = newLargest > newSmallest ? newLargest : newSmallest + 1.0;
}

void ValueAxis::SetPixels(double newLeft, double newRight)
{
  this->left = newLeft;
  this->right = std::max(newRight, newLeft + 1.0);
}

void ValueAxis::Fit(double newFirst, double newLast)
{
  const double room = RoomAtTheSides * (newLast - newFirst);
  this->Show(newFirst - room, newLast + room);
}

void ValueAxis::Zoom(double pixel, double factor)
{
  const double data = this->largest - this->smallest;
  const double width = std::clamp(
    (this->last - this->first) / factor, LeastPartOfData * data, LargestPartOfData * data);
  const double scale = width / (this->last - this->first);
  const double fixed = this->ToValue(pixel);
  this->Show(fixed + scale * (this->first - fixed), fixed + scale * (this->last - fixed));
}

void ValueAxis::Pan(double pixels)
{
  const double shift = -pixels * this->ValuePerPixel();
  this->Show(this->first + shift, this->last + shift);
}

void ValueAxis::Show(double newFirst, double newLast)
{
  const double data = this->largest - this->smallest;
  const double width =
    std::clamp(newLast - newFirst, LeastPartOfData * data, LargestPartOfData * data);
  const double middle =
    std::clamp(0.5 * (newFirst + newLast), this->smallest - data, this->largest + data);
  this->first = middle - 0.5 * width;
  this->last = middle + 0.5 * width;
}

double ValueAxis::ToPixel(double value) const
{
  return this->left + (value - this->first) / this->ValuePerPixel();
}

double ValueAxis::ToValue(double pixel) const
{
  return this->first + (pixel - this->left) * this->ValuePerPixel();
}

double ValueAxis::ValuePerPixel() const
{
  return (this->last - this->first) / (this->right - this->left);
}

double ValueAxis::Rounded(double value, double pixels) const
{
  // For decimals, divide by a whole number, so that the result equals the literal 0.3.
  const double exponent = std::floor(std::log10(pixels * this->ValuePerPixel()));
  const double power = std::pow(10.0, std::abs(exponent));
  return exponent < 0.0 ? std::round(value * power) / power : std::round(value / power) * power;
}

int ValueAxis::Decimals() const
{
  return std::max(0, int(-std::floor(std::log10(this->ValuePerPixel()))));
}

std::vector<double> ValueAxis::Ticks(double pixelsApart) const
{
  const double step = RoundAtLeast(pixelsApart * this->ValuePerPixel());
  std::vector<double> ticks;
  for (double i = std::ceil(this->first / step); i * step <= this->last; i += 1.0)
  {
    ticks.push_back(i * step);
  }
  return ticks;
}

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

HistogramBars::HistogramBars(const ImageStatistics& statistics, double leastWidth)
  : statistics(&statistics)
  , binsPerBar(std::max<std::int64_t>(1, std::ceil(leastWidth / statistics.BinSpacing())))
{
}

std::vector<HistogramBars::Bar> HistogramBars::Between(double first, double last) const
{
  const double smallest = std::max(first, this->statistics->Smallest());
  const double largest = std::min(last, this->statistics->Largest());
  std::vector<Bar> bars;
  if (smallest > largest)
  {
    return bars;
  }
  for (std::int64_t i = this->IndexOf(smallest); i <= this->IndexOf(largest); ++i)
  {
    bars.push_back(this->BarOfIndex(i));
  }
  return bars;
}

HistogramBars::Bar HistogramBars::At(double value) const
{
  return this->BarOfIndex(this->IndexOf(value));
}

HistogramBars::Bar HistogramBars::BarOfIndex(std::int64_t index) const
{
  // A bin is centred on its value.
  const double spacing = this->statistics->BinSpacing();
  const double width = double(this->binsPerBar) * spacing;
  const double first = this->statistics->Smallest() - 0.5 * spacing + double(index) * width;
  Bar bar{ first, first + width, 0 };
  const std::vector<std::int64_t>& counts = this->statistics->Counts();
  const std::int64_t bins = std::int64_t(counts.size());
  const std::int64_t begin = std::clamp<std::int64_t>(index * this->binsPerBar, 0, bins);
  const std::int64_t end = std::clamp<std::int64_t>((index + 1) * this->binsPerBar, 0, bins);
  for (std::int64_t bin = begin; bin < end; ++bin)
  {
    bar.count += counts[bin];
  }
  return bar;
}

std::int64_t HistogramBars::IndexOf(double value) const
{
  const double bin =
    std::floor((value - this->statistics->Smallest()) / this->statistics->BinSpacing() + 0.5);
  return std::int64_t(std::floor(bin / double(this->binsPerBar)));
}

}
