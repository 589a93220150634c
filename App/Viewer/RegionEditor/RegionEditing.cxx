#include "Viewer/RegionEditor/RegionEditing.h"

#include "Scene/LookRegions.h"

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

}
