#include "Viewer/Tools/MeasureTool.h"

#include "Scene/Measures.h"
#include "Scene/WorldVector.h"
#include "Viewer/View/MeasureOverlay.h"

#include <glm/geometric.hpp>

#include <QLineF>
#include <QPainter>

#include <algorithm>

namespace varimarch
{

namespace
{

constexpr double MeasureGrabPixels = 7.0;

using Point = MeasureTool::Point;

// The draggable points of a measurement; pointers to const for a const scene.
template <class SceneType>
auto PointsOf(SceneType& scene, MeasureKind kind, int measure)
  -> std::vector<decltype(&scene.distances[0].fromMm)>
{
  switch (kind)
  {
    case MeasureKind::Distance:
      return { &scene.distances[measure].fromMm, &scene.distances[measure].toMm };
    case MeasureKind::Angle:
      return { &scene.angles[measure].fromMm, &scene.angles[measure].vertexMm,
        &scene.angles[measure].toMm };
    default:
      return { &scene.boxes[measure].fromMm, &scene.boxes[measure].toMm };
  }
}

int CountOf(const Scene& scene, MeasureKind kind)
{
  switch (kind)
  {
    case MeasureKind::Distance:
      return int(scene.distances.size());
    case MeasureKind::Angle:
      return int(scene.angles.size());
    default:
      return int(scene.boxes.size());
  }
}

}

MeasureTool::MeasureTool(SceneModel* model, const ToolSurface& surface)
  : model(model)
  , surface(surface)
{
}

void MeasureTool::SetKind(MeasureKind newKind)
{
  this->kind = newKind;
  this->arm.reset();
}

std::optional<MeasureTool::PointId> MeasureTool::PointNear(const QPointF& place) const
{
  const Scene& scene = this->model->CurrentScene();
  const PictureFrame frame = this->surface.Frame();
  for (const MeasureKind of : { MeasureKind::Distance, MeasureKind::Angle, MeasureKind::Box })
  {
    for (int measure = 0; measure < CountOf(scene, of); ++measure)
    {
      const auto points = PointsOf(scene, of, measure);
      for (int i = 0; i < int(points.size()); ++i)
      {
        const std::optional<QPointF> pixel = frame.pixelOf(*points[i]);
        if (pixel && this->surface.Shows(*points.front(), *points.back()) &&
          QLineF(*pixel, place).length() <= MeasureGrabPixels)
        {
          return PointId{ of, measure, i };
        }
      }
    }
  }
  return std::nullopt;
}

bool MeasureTool::Press(const QPointF& place)
{
  this->gesture = NewGesture();
  this->isNew = false;
  this->grabbed = this->PointNear(place);
  if (this->grabbed)
  {
    return true;
  }
  const std::optional<Point> point = this->surface.PointAt(place);
  if (point)
  {
    this->Begin(*point);
  }
  return bool(point);
}

void MeasureTool::Begin(const Point& first)
{
  this->pressed = first;
  if (this->kind == MeasureKind::Angle && !this->arm)
  {
    this->arm = { first, first };
    return;
  }
  this->isNew = true;
  this->Edit(
    [&](Scene& scene)
    {
      if (this->kind == MeasureKind::Distance)
      {
        scene.distances.push_back({ first, first, {} });
      }
      else if (this->kind == MeasureKind::Angle)
      {
        scene.angles.push_back({ (*this->arm)[0], (*this->arm)[1], first, {} });
      }
      else
      {
        scene.boxes.push_back({ first, first, {} });
      }
    });
  this->arm.reset();
  const int last = CountOf(this->model->CurrentScene(), this->kind) - 1;
  this->grabbed = PointId{ this->kind, last, this->kind == MeasureKind::Angle ? 2 : 1 };
}

void MeasureTool::Drag(const QPointF& place)
{
  const std::optional<Point> point = this->surface.PointAt(place);
  if (!point)
  {
    return;
  }
  if (!this->grabbed)
  {
    (*this->arm)[1] = *point;
  }
  else if (this->isNew && this->kind == MeasureKind::Box && this->surface.Through())
  {
    this->MakeBox(*point);
  }
  else
  {
    this->MoveGrabbed(*point);
  }
}

// In a slice, a point keeps its position along the normal.
void MeasureTool::MoveGrabbed(const Point& to)
{
  this->Edit(
    [&](Scene& scene)
    {
      Point& moved =
        *PointsOf(scene, this->grabbed->kind, this->grabbed->measure)[this->grabbed->point];
      glm::dvec3 target = VectorOf(to);
      if (const auto through = this->surface.Through())
      {
        target += glm::dot(VectorOf(moved) - target, *through) * *through;
      }
      moved = NumbersOf(target);
    });
}

// In a slice, a new box is as deep as its shorter side.
void MeasureTool::MakeBox(const Point& to)
{
  const PictureFrame frame = this->surface.Frame();
  const glm::dvec3 diagonal = VectorOf(to) - VectorOf(this->pressed);
  const double side = std::min(std::abs(glm::dot(diagonal, VectorOf(frame.rightWorld))),
    std::abs(glm::dot(diagonal, VectorOf(frame.upWorld))));
  const glm::dvec3 half = 0.5 * side * *this->surface.Through();
  this->Edit(
    [&](Scene& scene)
    {
      scene.boxes.back().fromMm = NumbersOf(VectorOf(this->pressed) - half);
      scene.boxes.back().toMm = NumbersOf(VectorOf(to) + half);
    });
}

void MeasureTool::Edit(const std::function<void(Scene&)>& change)
{
  this->model->Edit(ScenePart::Measures, tr("measure"), change, this->gesture);
}

void MeasureTool::Release(const QPointF&)
{
  const Scene& scene = this->model->CurrentScene();
  const bool isEmpty = this->grabbed && this->isNew &&
    ((this->kind == MeasureKind::Distance && LengthMm(scene.distances.back()) == 0.0) ||
      (this->kind == MeasureKind::Box && scene.boxes.back().fromMm == scene.boxes.back().toMm));
  if (isEmpty)
  {
    this->model->History()->undo();
  }
  if (this->arm && (*this->arm)[0] == (*this->arm)[1])
  {
    this->arm.reset();
  }
  this->grabbed.reset();
}

void MeasureTool::Cancel()
{
  if (this->grabbed)
  {
    this->model->History()->undo();
  }
  this->grabbed.reset();
  this->arm.reset();
}

void MeasureTool::Paint(QPainter& painter) const
{
  if (!this->arm)
  {
    return;
  }
  const PictureFrame frame = this->surface.Frame();
  const std::optional<QPointF> from = frame.pixelOf((*this->arm)[0]);
  const std::optional<QPointF> to = frame.pixelOf((*this->arm)[1]);
  if (from && to)
  {
    DrawMark(painter, *from, *to);
  }
}

}
