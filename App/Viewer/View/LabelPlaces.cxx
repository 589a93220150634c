#include "Viewer/View/LabelPlaces.h"

#include <QLineF>

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

constexpr double Margin = 2.0; // logical pixels

}

LabelPlaces::LabelPlaces(const QSizeF& image)
  : inside(QRectF(QPointF(), image).adjusted(Margin, Margin, -Margin, -Margin))
{
}

bool LabelPlaces::IsFree(const QRectF& place) const
{
  return std::none_of(this->taken.begin(), this->taken.end(),
    [&](const QRectF& other) { return other.intersects(place); });
}

// Upper left corners at steps of a line and of a part of the width, the nearest first.
std::vector<QPointF> LabelPlaces::CornersNear(const QRectF& wanted) const
{
  constexpr double PartOfWidth = 0.25;
  const QPointF step(
    std::max(PartOfWidth * wanted.width(), 8.0), std::max(wanted.height() + 1.0, 8.0));
  const QPointF last = this->inside.bottomRight() - QPointF(wanted.width(), wanted.height());
  const auto first = [](double from, double at, double of)
  { return at - std::floor((at - from) / of) * of; };
  std::vector<QPointF> corners;
  for (double y = first(this->inside.top(), wanted.top(), step.y()); y <= last.y(); y += step.y())
  {
    for (double x = first(this->inside.left(), wanted.left(), step.x()); x <= last.x();
         x += step.x())
    {
      corners.emplace_back(x, y);
    }
  }
  std::sort(corners.begin(), corners.end(),
    [&](const QPointF& a, const QPointF& b)
    { return QLineF(a, wanted.topLeft()).length() < QLineF(b, wanted.topLeft()).length(); });
  return corners;
}

std::optional<QRectF> LabelPlaces::Take(const QRectF& wanted)
{
  const QSizeF size = wanted.size();
  const bool fits = size.width() <= this->inside.width() && size.height() <= this->inside.height();
  if (!fits ||
    (this->tooLarge && size.width() >= this->tooLarge->width() &&
      size.height() >= this->tooLarge->height()))
  {
    return std::nullopt;
  }
  QRectF place = wanted;
  place.moveLeft(
    std::clamp(wanted.left(), this->inside.left(), this->inside.right() - size.width()));
  place.moveTop(
    std::clamp(wanted.top(), this->inside.top(), this->inside.bottom() - size.height()));
  if (!this->IsFree(place))
  {
    const std::vector<QPointF> corners = this->CornersNear(place);
    const auto free = std::find_if(corners.begin(), corners.end(),
      [&](const QPointF& corner) {
        return this->IsFree({ corner, size });
      });
    if (free == corners.end())
    {
      this->tooLarge = size;
      return std::nullopt;
    }
    place.moveTopLeft(*free);
  }
  this->taken.push_back(place);
  return place;
}

}
