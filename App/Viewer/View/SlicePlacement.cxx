#include "Viewer/View/SlicePlacement.h"

#include "Scene/Model/SceneCuts.h"
#include "Scene/Model/WorldVector.h"

#include <QRectF>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace varimarch
{

SlicePlacement::SlicePlacement(vtkImageData* image, const SliceAxes& axes,
  const std::array<double, 3>& pointMm, const QSize& view, const SliceZoom& zoom)
  : axes(axes)
  , centre(QRectF(QPointF(), view).center())
{
  const auto acrossMm = [image](const std::array<double, 3>& direction)
  {
    const auto [first, last] = ReachAlong(direction, image);
    return last - first;
  };
  this->mmPerPixel = std::max(acrossMm(this->axes.right) / std::max(view.width(), 1),
                       acrossMm(this->axes.down) / std::max(view.height(), 1)) /
    zoom.factor;
  // The view does not scroll when the crosshair moves within it.
  const glm::dvec3 middle = VectorOf(MiddleOf(image));
  const glm::dvec3 through = VectorOf(this->axes.through);
  this->middleMm = NumbersOf(middle + glm::dot(VectorOf(pointMm) - middle, through) * through +
    zoom.shiftMm.x() * VectorOf(this->axes.right) + zoom.shiftMm.y() * VectorOf(this->axes.down));
}

std::array<double, 3> SlicePlacement::PointAt(const QPointF& place) const
{
  const QPointF fromMiddle = this->mmPerPixel * (place - this->centre);
  return NumbersOf(VectorOf(this->middleMm) + fromMiddle.x() * VectorOf(this->axes.right) +
    fromMiddle.y() * VectorOf(this->axes.down));
}

QPointF SlicePlacement::PlaceOf(const std::array<double, 3>& pointMm) const
{
  const glm::dvec3 fromMiddle = VectorOf(pointMm) - VectorOf(this->middleMm);
  return this->centre + this->AlongView(NumbersOf(fromMiddle)) / this->mmPerPixel;
}

QPointF SlicePlacement::AlongView(const std::array<double, 3>& direction) const
{
  return { glm::dot(VectorOf(direction), VectorOf(this->axes.right)),
    glm::dot(VectorOf(direction), VectorOf(this->axes.down)) };
}

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
