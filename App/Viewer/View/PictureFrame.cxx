#include "Viewer/View/PictureFrame.h"

#include "Scene/Model/WorldVector.h"

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkSmartPointer.h>

#include <glm/geometric.hpp>

#include <QLineF>

#include <cmath>

namespace varimarch
{

namespace
{

// Sine of the smallest angle between a line and the line of sight at which dragging along the line
// is well defined.
constexpr double SmallestSine = 0.2;

glm::dvec3 PointAtDepth(
  const QPointF& place, double depth, const QSizeF& size, vtkMatrix4x4* worldFromClip)
{
  double point[4] = { 2.0 * place.x() / size.width() - 1.0, 1.0 - 2.0 * place.y() / size.height(),
    depth, 1.0 };
  worldFromClip->MultiplyPoint(point, point);
  return glm::dvec3(point[0], point[1], point[2]) / point[3];
}

}

double PictureFrame::PixelsPerMm(const std::array<double, 3>& point) const
{
  const glm::dvec3 above = VectorOf(point) + VectorOf(this->upWorld);
  const std::optional<QPointF> first = this->pixelOf(point);
  const std::optional<QPointF> second = this->pixelOf(NumbersOf(above));
  return first && second ? QLineF(*first, *second).length() : 0.0;
}

PictureFrame FrameOf(vtkCamera* camera, const QSizeF& size)
{
  vtkMatrix4x4* const viewFromWorld = camera->GetViewTransformMatrix();
  const auto row = [&](int i)
  {
    const auto element = [&](int j) { return viewFromWorld->GetElement(i, j); };
    return std::array<double, 3>{ element(0), element(1), element(2) };
  };
  auto clipFromWorld = vtkSmartPointer<vtkMatrix4x4>::New();
  clipFromWorld->DeepCopy(
    camera->GetCompositeProjectionTransformMatrix(size.width() / size.height(), -1.0, 1.0));
  auto worldFromClip = vtkSmartPointer<vtkMatrix4x4>::New();
  vtkMatrix4x4::Invert(clipFromWorld, worldFromClip);
  const auto pixelOf = [clipFromWorld, size](const std::array<double, 3>& point)
  {
    double clip[4] = { point[0], point[1], point[2], 1.0 };
    clipFromWorld->MultiplyPoint(clip, clip);
    const QPointF pixel(0.5 * (1.0 + clip[0] / clip[3]) * size.width(),
      0.5 * (1.0 - clip[1] / clip[3]) * size.height());
    return clip[3] > 0.0 ? std::optional<QPointF>(pixel) : std::nullopt;
  };
  const auto sightLineAt = [worldFromClip, size](const QPointF& place)
  {
    return SightLine{ PointAtDepth(place, -1.0, size, worldFromClip),
      PointAtDepth(place, 1.0, size, worldFromClip) };
  };
  return { size, pixelOf, sightLineAt, row(0), row(1), row(2) };
}

std::optional<double> NearestAlong(
  const glm::dvec3& point, const glm::dvec3& direction, const SightLine& sight)
{
  const glm::dvec3 along = glm::normalize(sight.farthest - sight.nearest);
  const double cosine = glm::dot(direction, along);
  const double squaredSine = 1.0 - cosine * cosine;
  if (squaredSine < SmallestSine * SmallestSine)
  {
    return std::nullopt;
  }
  const glm::dvec3 between = sight.nearest - point;
  return (glm::dot(between, direction) - cosine * glm::dot(between, along)) / squaredSine;
}

glm::dvec3 DirectionOnSphere(
  const glm::dvec3& middle, double radiusMm, const glm::dvec3& side, const SightLine& sight)
{
  const glm::dvec3 along = glm::normalize(sight.farthest - sight.nearest);
  const glm::dvec3 nearest =
    sight.nearest + glm::dot(middle - sight.nearest, along) * along - middle;
  const double squaredHalf = radiusMm * radiusMm - glm::dot(nearest, nearest);
  if (squaredHalf <= 0.0)
  {
    return glm::normalize(nearest);
  }
  const double sign = glm::dot(side, along) < 0.0 ? -1.0 : 1.0;
  return glm::normalize(nearest + sign * std::sqrt(squaredHalf) * along);
}

}
