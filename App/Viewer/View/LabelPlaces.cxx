#include "Viewer/View/LabelPlaces.h"

#include <QLineF>

#include <algorithm>
#include <cmath>
#include <limits>

namespace varimarch
{

namespace
{

constexpr double MarginOfLabel = 2.0; // logical pixels

}

LabelPlaces::LabelPlaces(const QSizeF& image, const std::vector<QRectF>& newTaken)
  : inside(QRectF(QPointF(), image)
             .adjusted(MarginOfLabel, MarginOfLabel, -MarginOfLabel, -MarginOfLabel))
  , taken(newTaken)
{
}

bool LabelPlaces::IsFree(const QRectF& place) const
{
  return std::none_of(this->taken.begin(), this->taken.end(),
    [&](const QRectF& other) { return other.intersects(place); });
}

// Looks at corners at steps of a line and of a part of the width.
std::optional<QPointF> LabelPlaces::NearestFree(const QRectF& wanted) const
{
  constexpr double PartOfWidth = 0.25;
  const QPointF step(
    std::max(PartOfWidth * wanted.width(), 8.0), std::max(wanted.height() + 1.0, 8.0));
  const QPointF last = this->inside.bottomRight() - QPointF(wanted.width(), wanted.height());
  const auto first = [](double from, double at, double of)
  { return at - std::floor((at - from) / of) * of; };
  std::optional<QPointF> nearest;
  double least = std::numeric_limits<double>::infinity();
  for (double y = first(this->inside.top(), wanted.top(), step.y()); y <= last.y(); y += step.y())
  {
    for (double x = first(this->inside.left(), wanted.left(), step.x()); x <= last.x();
         x += step.x())
    {
      const QPointF corner(x, y);
      const double distance = QLineF(corner, wanted.topLeft()).length();
      if (distance < least && this->IsFree({ corner, wanted.size() }))
      {
        nearest = corner;
        least = distance;
      }
    }
  }
  return nearest;
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
    const std::optional<QPointF> free = this->NearestFree(place);
    if (!free)
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
