#include "Viewer/Tools/CutHandles.h"

#include "Scene/SceneCuts.h"
#include "Scene/WorldVector.h"

#include <vtkBox.h>
#include <vtkImageData.h>

#include <QLineF>
#include <QPainter>

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

}
