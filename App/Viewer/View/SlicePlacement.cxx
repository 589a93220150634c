#include "Viewer/View/SlicePlacement.h"

#include "Scene/SceneCuts.h"
#include "Scene/WorldVector.h"

#include <QRectF>

#include <glm/geometric.hpp>

#include <algorithm>

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

}
