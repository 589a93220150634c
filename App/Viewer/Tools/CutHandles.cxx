#include "Viewer/Tools/CutHandles.h"

#include "Scene/Model/SceneCuts.h"
#include "Scene/Model/WorldVector.h"

#include <QLineF>
#include <QPainter>

#include <vtkBoundingBox.h>
#include <vtkBox.h>
#include <vtkImageData.h>

#include <glm/geometric.hpp>

#include <algorithm>

namespace varimarch
{

namespace
{

constexpr double HandleGrabPixels = 11.0;
constexpr double DiscPixels = 6.0;
const QColor PlaneColor(255, 190, 60);
const QColor BoxColor(120, 200, 255);
const QColor EdgeColor(20, 20, 20, 200);

QString StepName(CutHandleKind kind)
{
  switch (kind)
  {
    case CutHandleKind::PushPlane:
      return CutHandles::tr("push a plane");
    case CutHandleKind::TurnPlane:
      return CutHandles::tr("rotate a plane");
    case CutHandleKind::MoveFace:
      return CutHandles::tr("crop");
    default:
      return CutHandles::tr("move the box");
  }
}

// Draws a line that is visible on any background.
void DrawLine(QPainter& painter, const QPointF& from, const QPointF& to, const QColor& color)
{
  painter.setPen(QPen(QColor(0, 0, 0, 90), 3.0));
  painter.drawLine(from, to);
  painter.setPen(QPen(color, 1.2));
  painter.drawLine(from, to);
}

void DrawEdge(QPainter& painter, const glm::dvec3& from, const glm::dvec3& to,
  const PictureFrame& frame, const QColor& color)
{
  const auto first = frame.pixelOf(NumbersOf(from));
  const auto second = frame.pixelOf(NumbersOf(to));
  if (first && second)
  {
    DrawLine(painter, *first, *second, color);
  }
}

QColor Faint(QColor color)
{
  color.setAlpha(150);
  return color;
}

}

CutHandles::CutHandles(SceneModel* model, const ToolSurface& surface)
  : model(model)
  , surface(surface)
{
}

std::optional<CutHandle> CutHandles::HandleAt(const QPointF& place) const
{
  if (!this->shown || !this->model->CurrentStudy())
  {
    return std::nullopt;
  }
  const PictureFrame frame = this->surface.Frame();
  for (const CutHandle& handle : HandlesOf(this->model->CurrentScene().cuts, this->Image(), frame))
  {
    const std::optional<QPointF> pixel = frame.pixelOf(handle.pointMm);
    if (pixel && QLineF(*pixel, place).length() <= HandleGrabPixels)
    {
      return handle;
    }
  }
  return std::nullopt;
}

bool CutHandles::Press(const QPointF& place)
{
  this->grabbed = this->HandleAt(place);
  this->pressed = place;
  this->before = this->model->CurrentScene().cuts;
  this->gesture = NewGesture();
  return bool(this->grabbed);
}

void CutHandles::Drag(const QPointF& place)
{
  const SceneCuts cuts = Dragged(
    this->before, *this->grabbed, { this->pressed, place, this->surface.Frame() }, this->Image());
  this->model->Edit(
    ScenePart::Cuts, StepName(this->grabbed->kind), [&](Scene& scene) { scene.cuts = cuts; },
    this->gesture);
}

void CutHandles::Release(const QPointF&)
{
  this->grabbed.reset();
}

void CutHandles::Cancel()
{
  this->Drag(this->pressed);
  this->grabbed.reset();
}

void CutHandles::Paint(QPainter& painter) const
{
  if (!this->shown || !this->model->CurrentStudy())
  {
    return;
  }
  const PictureFrame frame = this->surface.Frame();
  painter.setRenderHint(QPainter::Antialiasing);
  this->PaintBox(painter, frame);
  this->PaintPlanes(painter, frame);
  const std::vector<CutHandle> handles =
    HandlesOf(this->model->CurrentScene().cuts, this->Image(), frame);
  // Paint in reverse, so that the handle that is grabbed first lies on top.
  std::for_each(handles.rbegin(), handles.rend(),
    [&](const CutHandle& handle) { this->PaintHandle(painter, handle, frame); });
}

// Outlines the section of each plane with the volume.
void CutHandles::PaintPlanes(QPainter& painter, const PictureFrame& frame) const
{
  double bounds[6];
  this->Image()->GetBounds(bounds);
  for (const CutPlane& plane : this->model->CurrentScene().cuts.planes)
  {
    std::array<double, 3> point = plane.pointMm;
    std::array<double, 3> normal = plane.normal;
    std::array<std::array<double, 3>, 6> corners;
    const int count =
      vtkBox::IntersectWithPlane(bounds, point.data(), normal.data(), corners[0].data());
    for (int i = 0; i < count; ++i)
    {
      DrawEdge(painter, VectorOf(corners[i]), VectorOf(corners[(i + 1) % count]), frame,
        Faint(PlaneColor));
    }
  }
}

void CutHandles::PaintBox(QPainter& painter, const PictureFrame& frame) const
{
  const std::array<double, 6>& box = this->model->CurrentScene().cuts.box;
  const auto corner = [&](int i)
  {
    const glm::dvec3 parts(box[i & 1], box[2 + (i >> 1 & 1)], box[4 + (i >> 2)]);
    return PointAtParts(parts, this->Image());
  };
  for (int first = 0; first < 8; ++first)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      if (!(first >> axis & 1))
      {
        DrawEdge(painter, corner(first), corner(first | 1 << axis), frame, Faint(BoxColor));
      }
    }
  }
}

void CutHandles::PaintHandle(
  QPainter& painter, const CutHandle& handle, const PictureFrame& frame) const
{
  const std::optional<QPointF> place = frame.pixelOf(handle.pointMm);
  if (!place)
  {
    return;
  }
  const bool ofPlane =
    handle.kind == CutHandleKind::PushPlane || handle.kind == CutHandleKind::TurnPlane;
  const bool hovered = QLineF(*place, this->pointer).length() <= HandleGrabPixels;
  const double radius = DiscPixels * (hovered ? 1.4 : 1.0);
  if (handle.kind == CutHandleKind::TurnPlane)
  {
    const CutPlane& plane = this->model->CurrentScene().cuts.planes[handle.index];
    DrawEdge(painter, PlaneFoot(plane, this->Image()), VectorOf(handle.pointMm), frame, PlaneColor);
  }
  painter.setPen(QPen(EdgeColor, 1.5));
  painter.setBrush(ofPlane ? PlaneColor : BoxColor);
  if (handle.kind == CutHandleKind::TurnPlane || handle.kind == CutHandleKind::MoveBox)
  {
    painter.drawEllipse(*place, radius, radius);
  }
  else
  {
    painter.drawRoundedRect(
      QRectF(*place - QPointF(radius, radius), QSizeF(2.0 * radius, 2.0 * radius)), 2.0, 2.0);
  }
}

namespace
{

constexpr double ArrowPixels = 70.0;

glm::dvec3 AwayFrom(const CutPlane& plane)
{
  return -glm::normalize(VectorOf(plane.normal));
}

double ArrowMm(const glm::dvec3& foot, const PictureFrame& frame)
{
  return ArrowPixels / std::max(frame.PixelsPerMm(NumbersOf(foot)), 1e-6);
}

glm::dvec3 MiddlePartsOf(const std::array<double, 6>& box)
{
  return 0.5 * glm::dvec3(box[0] + box[1], box[2] + box[3], box[4] + box[5]);
}

// Distance that the mouse drags a point along a line [mm]. If the line points towards the eye,
// dragging upwards pushes away from it.
double MovedAlong(const glm::dvec3& point, const glm::dvec3& direction, const MouseDrag& drag)
{
  const auto from = NearestAlong(point, direction, drag.frame.sightLineAt(drag.from));
  const auto to = NearestAlong(point, direction, drag.frame.sightLineAt(drag.to));
  if (from && to)
  {
    return *to - *from;
  }
  const double upwardsMm =
    (drag.from.y() - drag.to.y()) / std::max(drag.frame.PixelsPerMm(NumbersOf(point)), 1e-6);
  return glm::dot(direction, VectorOf(drag.frame.towardsEyeWorld)) < 0.0 ? upwardsMm : -upwardsMm;
}

CutPlane Pushed(
  const CutPlane& plane, const glm::dvec3& foot, const MouseDrag& drag, vtkImageData* image)
{
  const glm::dvec3 normal = glm::normalize(VectorOf(plane.normal));
  const auto [first, last] = ReachAlong(plane.normal, image);
  const double now = glm::dot(normal, foot - VectorOf(MiddleOf(image)));
  const double moved = std::clamp(MovedAlong(foot, normal, drag), first - now, last - now);
  return { NumbersOf(foot + moved * normal), plane.normal };
}

CutPlane Turned(
  const CutPlane& plane, const glm::dvec3& tip, const MouseDrag& drag, vtkImageData* image)
{
  const glm::dvec3 foot = PlaneFoot(plane, image);
  const glm::dvec3 away = DirectionOnSphere(
    foot, glm::distance(foot, tip), AwayFrom(plane), drag.frame.sightLineAt(drag.to));
  return { NumbersOf(foot), NumbersOf(-away) };
}

// Fraction of the volume that the mouse drags a point along one of its axes.
double MovedPart(const glm::dvec3& point, int axis, const MouseDrag& drag, vtkImageData* image)
{
  glm::dvec3 last(0.0);
  last[axis] = 1.0;
  const glm::dvec3 along = PointAtParts(last, image) - PointAtParts(glm::dvec3(0.0), image);
  const double lengthMm = glm::length(along);
  return lengthMm > 0.0 ? MovedAlong(point, along / lengthMm, drag) / lengthMm : 0.0;
}

void MoveBox(
  std::array<double, 6>& box, const glm::dvec3& middle, const MouseDrag& drag, vtkImageData* image)
{
  const double mmPerPixel = 1.0 / std::max(drag.frame.PixelsPerMm(NumbersOf(middle)), 1e-6);
  const QPointF moved = mmPerPixel * (drag.to - drag.from);
  const glm::dvec3 movedMm =
    moved.x() * VectorOf(drag.frame.rightWorld) - moved.y() * VectorOf(drag.frame.upWorld);
  for (int axis = 0; axis < 3; ++axis)
  {
    glm::dvec3 last(0.0);
    last[axis] = 1.0;
    const glm::dvec3 along = PointAtParts(last, image) - PointAtParts(glm::dvec3(0.0), image);
    const double squaredMm = std::max(glm::dot(along, along), 1e-12);
    const double part =
      std::clamp(glm::dot(movedMm, along) / squaredMm, -box[2 * axis], 1.0 - box[2 * axis + 1]);
    box[2 * axis] += part;
    box[2 * axis + 1] += part;
  }
}

}

glm::dvec3 PlaneFoot(const CutPlane& plane, vtkImageData* image)
{
  const bool inside = vtkBoundingBox(image->GetBounds()).ContainsPoint(plane.pointMm.data());
  return VectorOf(inside ? plane.pointMm : AtDepth(DepthOf(plane, image), plane, image).pointMm);
}

std::vector<CutHandle> HandlesOf(
  const SceneCuts& cuts, vtkImageData* image, const PictureFrame& frame)
{
  std::vector<CutHandle> handles;
  for (int i = 0; i < int(cuts.planes.size()); ++i)
  {
    const glm::dvec3 foot = PlaneFoot(cuts.planes[i], image);
    const glm::dvec3 tip = foot + ArrowMm(foot, frame) * AwayFrom(cuts.planes[i]);
    handles.push_back({ CutHandleKind::PushPlane, i, NumbersOf(foot) });
    handles.push_back({ CutHandleKind::TurnPlane, i, NumbersOf(tip) });
  }
  // The box comes before its faces: seen from the front, the centre hides two of their handles.
  const glm::dvec3 middle = MiddlePartsOf(cuts.box);
  if (cuts.box != SceneCuts().box)
  {
    handles.push_back({ CutHandleKind::MoveBox, 0, NumbersOf(PointAtParts(middle, image)) });
  }
  for (int face = 0; face < 6; ++face)
  {
    glm::dvec3 parts = middle;
    parts[face / 2] = cuts.box[face];
    handles.push_back({ CutHandleKind::MoveFace, face, NumbersOf(PointAtParts(parts, image)) });
  }
  return handles;
}

SceneCuts Dragged(
  const SceneCuts& cuts, const CutHandle& handle, const MouseDrag& drag, vtkImageData* image)
{
  SceneCuts dragged = cuts;
  const glm::dvec3 point = VectorOf(handle.pointMm);
  switch (handle.kind)
  {
    case CutHandleKind::PushPlane:
      dragged.planes[handle.index] = Pushed(cuts.planes[handle.index], point, drag, image);
      break;
    case CutHandleKind::TurnPlane:
      dragged.planes[handle.index] = Turned(cuts.planes[handle.index], point, drag, image);
      break;
    case CutHandleKind::MoveFace:
      MoveFace(dragged.box, handle.index,
        cuts.box[handle.index] + MovedPart(point, handle.index / 2, drag, image));
      break;
    case CutHandleKind::MoveBox:
      MoveBox(dragged.box, point, drag, image);
      break;
  }
  return dragged;
}

}
