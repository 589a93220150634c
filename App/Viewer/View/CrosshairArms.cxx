#include "Viewer/View/CrosshairArms.h"

#include "Scene/WorldVector.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace varimarch
{

CrosshairArms::CrosshairArms(SlicePlane plane, const SliceTurn& turn,
  const SlicePlacement& placement, const std::array<double, 3>& crosshairMm, const QSize& view)
  : turn(turn)
  , middle(placement.PlaceOf(crosshairMm))
{
  constexpr double InnerPart = 0.15; // part of the view's shorter side
  this->innerPixels = InnerPart * std::min(view.width(), view.height());
  const SliceAxes axes = AxesOf(plane, turn);
  this->axis = NumbersOf(glm::cross(VectorOf(axes.right), VectorOf(axes.down)));
  auto* direction = this->directions.begin();
  for (const SlicePlane other : { SlicePlane::Axial, SlicePlane::Coronal, SlicePlane::Sagittal })
  {
    if (other != plane)
    {
      const glm::dvec3 line =
        glm::cross(VectorOf(axes.through), VectorOf(AxesOf(other, turn).through));
      *direction++ = placement.AlongView(NumbersOf(line));
    }
  }
}

bool CrosshairArms::Hold(const QPointF& place) const
{
  constexpr double ReachPixels = 6.0;
  const QPointF from = place - this->middle;
  return std::hypot(from.x(), from.y()) > this->innerPixels &&
    std::any_of(this->directions.begin(), this->directions.end(),
      [&](const QPointF& along)
      { return std::abs(along.x() * from.y() - along.y() * from.x()) < ReachPixels; });
}

SliceTurn CrosshairArms::Dragged(const QPointF& from, const QPointF& to) const
{
  const auto angleOf = [this](const QPointF& place)
  { return std::atan2(place.y() - this->middle.y(), place.x() - this->middle.x()); };
  return TurnedBy(this->turn, this->axis, glm::degrees(angleOf(to) - angleOf(from)));
}

}
