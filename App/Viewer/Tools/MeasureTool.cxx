#include "Viewer/Tools/MeasureTool.h"

#include "Scene/Measures/MeasureKinds.h"
#include "Scene/Model/WorldVector.h"
#include "Viewer/View/Overlay.h"

#include <glm/geometric.hpp>

#include <QLineF>
#include <QPainter>

#include <algorithm>
#include <map>

namespace varimarch
{

namespace
{

constexpr double MeasureGrabPixels = 7.0;

using Point = MeasureTool::Point;

/// A drag across a view, from a point of its slice to another.
struct MeasureDrag
{
  glm::dvec3 from;
  glm::dvec3 to;
  glm::dvec3 right; ///< unit vectors of the view
  glm::dvec3 up;
  glm::dvec3 through; ///< normal of the slice
};

// A box is as deep as its shorter side.
void MakeBox(const MeasureDrag& drag, std::vector<Point>& points)
{
  const glm::dvec3 diagonal = drag.to - drag.from;
  const double side =
    std::min(std::abs(glm::dot(diagonal, drag.right)), std::abs(glm::dot(diagonal, drag.up)));
  const glm::dvec3 half = 0.5 * side * drag.through;
  points = { NumbersOf(drag.from - half), NumbersOf(drag.to + half) };
}

// The ellipse touches the sides of the rectangle that is dragged.
void MakeEllipse(const MeasureDrag& drag, std::vector<Point>& points)
{
  const glm::dvec3 half = 0.5 * (drag.to - drag.from);
  const glm::dvec3 middle = drag.from + half;
  points = { NumbersOf(middle), NumbersOf(middle + glm::dot(half, drag.right) * drag.right),
    NumbersOf(middle + glm::dot(half, drag.up) * drag.up) };
}

void ExtendOutline(const MeasureDrag& drag, std::vector<Point>& points)
{
  if (points.size() < MostMeasurePoints && NumbersOf(drag.to) != points.back())
  {
    points.push_back(NumbersOf(drag.to));
  }
}

using Shape = void (*)(const MeasureDrag&, std::vector<Point>&);

// The kinds that one drag in a slice shapes as a whole; null for the others.
Shape ShapeOf(MeasureKind kind)
{
  static const std::map<MeasureKind, Shape> shapes = { { MeasureKind::Box, &MakeBox },
    { MeasureKind::Ellipse, &MakeEllipse }, { MeasureKind::Freehand, &ExtendOutline } };
  const auto shape = shapes.find(kind);
  return shape == shapes.end() ? nullptr : shape->second;
}

}

MeasureTool::MeasureTool(SceneModel* model, ToolSurface& surface)
  : model(model)
  , surface(surface)
{
}

void MeasureTool::SetKind(MeasureKind newKind)
{
  this->kind = newKind;
  this->Forget();
}

void MeasureTool::Forget()
{
  this->countBefore = this->model->CurrentScene().measures.size();
  this->begun.clear();
}

std::optional<MeasureTool::PointId> MeasureTool::PointNear(const QPointF& place) const
{
  const Scene& scene = this->model->CurrentScene();
  const PictureFrame frame = this->surface.Frame();
  for (std::size_t i = 0; i < scene.measures.size(); ++i)
  {
    const Measure& measure = scene.measures[i];
    const std::size_t handles = HandleCount(measure);
    for (std::size_t point = 0; point < handles && measure.visible; ++point)
    {
      const std::optional<QPointF> pixel = frame.pixelOf(measure.pointsMm[point]);
      if (pixel && QLineF(*pixel, place).length() <= MeasureGrabPixels &&
        this->surface.Shows(PointsOf(measure)))
      {
        return PointId{ int(i), int(point) };
      }
    }
  }
  return std::nullopt;
}

bool MeasureTool::Press(const QPointF& place)
{
  this->gesture = NewGesture();
  this->stepsBefore = this->model->History()->index();
  this->isNew = false;
  this->grabbed = this->PointNear(place);
  if (this->grabbed)
  {
    return true;
  }
  const std::optional<Point> point = this->surface.PointAt(place);
  const bool isPossible = point && (this->surface.Through() || !TraitsOf(this->kind).isFlat) &&
    this->model->CurrentScene().measures.size() < MostMeasures;
  if (isPossible)
  {
    // An outline needs every move, also those made while the program was busy.
    QCoreApplication::setAttribute(
      Qt::AA_CompressHighFrequencyEvents, this->kind != MeasureKind::Freehand);
    this->Begin(*point);
  }
  return isPossible;
}

void MeasureTool::Begin(const Point& first)
{
  this->pressed = first;
  if (this->kind == MeasureKind::Curve)
  {
    this->ContinueCurve(first);
    return;
  }
  const std::size_t count = TraitsOf(this->kind).fewestPoints;
  if (ShapeOf(this->kind))
  {
    this->BeginMeasure(std::vector<Point>(count, first));
    return;
  }
  // A stroke has two points, or the only one that is missing.
  this->begun.resize(std::min(count, this->begun.size() + 2), first);
  if (this->begun.size() == count)
  {
    this->BeginMeasure(std::move(this->begun));
    this->begun.clear();
  }
}

void MeasureTool::BeginMeasure(std::vector<Point> points)
{
  this->isNew = true;
  this->Edit([&](Scene& scene) { scene.measures.push_back({ this->kind, points }); });
  this->grabbed = PointId{ int(this->model->CurrentScene().measures.size()) - 1,
    int(TraitsOf(this->kind).fewestPoints) - 1 };
}

// True if the last measurement is a curve that is seen and was begun since the kind was chosen, in
// this view or another.
bool MeasureTool::Continues(const Scene& scene) const
{
  return scene.measures.size() > this->countBefore &&
    scene.measures.back().kind == MeasureKind::Curve && scene.measures.back().visible &&
    scene.measures.back().pointsMm.size() < MostMeasurePoints;
}

void MeasureTool::ContinueCurve(const Point& point)
{
  if (!this->Continues(this->model->CurrentScene()))
  {
    this->BeginMeasure({ point });
    return;
  }
  this->Edit([&](Scene& scene) { scene.measures.back().pointsMm.push_back(point); });
  const std::vector<Measure>& measures = this->model->CurrentScene().measures;
  this->grabbed = PointId{ int(measures.size()) - 1, int(measures.back().pointsMm.size()) - 1 };
}

// An undo during a drag may take the measurement away.
void MeasureTool::ForgetUndone()
{
  const std::vector<Measure>& measures = this->model->CurrentScene().measures;
  if (this->grabbed &&
    (this->grabbed->measure >= int(measures.size()) ||
      this->grabbed->point >= int(measures[this->grabbed->measure].pointsMm.size())))
  {
    this->grabbed.reset();
  }
}

void MeasureTool::Drag(const QPointF& place)
{
  this->ForgetUndone();
  const std::optional<Point> point = this->surface.PointAt(place);
  if (!point || (!this->grabbed && this->begun.empty()))
  {
    return;
  }
  if (!this->grabbed)
  {
    this->begun.back() = *point;
  }
  else if (this->isNew && ShapeOf(this->kind) && this->surface.Through())
  {
    this->Reshape(*point);
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
      Measure& measure = scene.measures[this->grabbed->measure];
      const glm::dvec3 before = VectorOf(measure.pointsMm[this->grabbed->point]);
      glm::dvec3 step = VectorOf(to) - before;
      if (const auto through = this->surface.Through())
      {
        step -= glm::dot(step, *through) * *through;
      }
      MovePoint(measure, this->grabbed->point, step);
    });
}

void MeasureTool::Reshape(const Point& to)
{
  const PictureFrame frame = this->surface.Frame();
  const MeasureDrag drag = { VectorOf(this->pressed), VectorOf(to), VectorOf(frame.rightWorld),
    VectorOf(frame.upWorld), *this->surface.Through() };
  this->Edit([&](Scene& scene)
    { ShapeOf(this->kind)(drag, scene.measures[this->grabbed->measure].pointsMm); });
}

void MeasureTool::Edit(const std::function<void(Scene&)>& change)
{
  this->model->Edit(ScenePart::Measures, tr("measure"), change, this->gesture);
}

// True for a measurement that a click has made, although its kind needs a drag: the points of the
// last stroke coincide.
bool MeasureTool::IsEmpty() const
{
  const std::size_t fewest = TraitsOf(this->kind).fewestPoints;
  const std::vector<Point>& points =
    this->model->CurrentScene().measures[this->grabbed->measure].pointsMm;
  const std::size_t ofStroke = ShapeOf(this->kind) ? points.size() : 2 - fewest % 2;
  return ofStroke > 1 &&
    std::all_of(points.end() - std::ptrdiff_t(ofStroke), points.end(),
      [&](const Point& point) { return point == points.back(); });
}

void MeasureTool::Release(const QPointF& place)
{
  QCoreApplication::setAttribute(Qt::AA_CompressHighFrequencyEvents, true);
  this->ForgetUndone();
  if (this->grabbed && this->isNew && this->IsEmpty())
  {
    this->model->History()->undo();
  }
  else if (this->grabbed && this->isNew && TraitsOf(this->kind).hasWords)
  {
    this->AskForWords(place);
  }
  if (!this->grabbed && this->begun.size() == 2 && this->begun[0] == this->begun[1])
  {
    this->begun.clear();
  }
  this->grabbed.reset();
}

// A text without words is not made. The scene may have changed until the words come.
void MeasureTool::AskForWords(const QPointF& place)
{
  const auto take = [scenes = this->model, number = this->grabbed->measure, kind = this->kind,
                      points = this->model->CurrentScene().measures.back().pointsMm,
                      gesture = this->gesture](const QString& words)
  {
    const std::vector<Measure>& measures = scenes->CurrentScene().measures;
    if (number >= int(measures.size()) || measures[number].kind != kind ||
      measures[number].pointsMm != points)
    {
      return;
    }
    scenes->Edit(
      ScenePart::Measures, tr("measure"),
      [&](Scene& scene)
      {
        scene.measures[number].name = words.toStdString();
        if (words.isEmpty() && kind == MeasureKind::Text)
        {
          scene.measures.erase(scene.measures.begin() + number);
        }
      },
      gesture);
  };
  this->surface.AskForWords(place, take);
}

// A point that was pressed but not moved is no step.
void MeasureTool::Cancel()
{
  QCoreApplication::setAttribute(Qt::AA_CompressHighFrequencyEvents, true);
  if (this->grabbed && this->model->History()->index() > this->stepsBefore)
  {
    this->model->History()->undo();
  }
  this->grabbed.reset();
  this->begun.clear();
}

void MeasureTool::Paint(QPainter& painter) const
{
  const PictureFrame frame = this->surface.Frame();
  for (std::size_t i = 0; i + 1 < this->begun.size(); i += 2)
  {
    const std::optional<QPointF> from = frame.pixelOf(this->begun[i]);
    const std::optional<QPointF> to = frame.pixelOf(this->begun[i + 1]);
    if (from && to)
    {
      DrawMark(painter, *from, *to);
    }
  }
}

}
