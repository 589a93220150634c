#include "Viewer/Tools/MouseTool.h"

#include "Scene/Looks/LookRegions.h"
#include "Scene/Model/SceneCamera.h"
#include "Scene/Model/WorldVector.h"
#include "Viewer/TransferFunctionEditor/LookEditing.h"

#include <QKeyEvent>
#include <QLineF>
#include <QPainter>

#include <vtkImageData.h>

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace varimarch
{

namespace
{

constexpr double WidestFactor = 10.0;

}

BrightnessTool::BrightnessTool(SceneModel* model, const ToolSurface& surface)
  : model(model)
  , surface(surface)
{
}

bool BrightnessTool::Press(const QPointF& place)
{
  this->pressed = place;
  this->before = this->model->EditedLook();
  this->gesture = NewGesture();
  return true;
}

// A drag across the whole view shifts by half of the data's range, or scales by the factor e.
void BrightnessTool::Drag(const QPointF& place)
{
  const QSizeF size = this->surface.Frame().size;
  const QPointF moved = (place - this->pressed) / std::min(size.width(), size.height());
  const ImageStatistics& statistics = this->model->EditedStudy()->statistics;
  const double range = statistics.Percentile(99.9) - statistics.Percentile(0.1);
  const double factor = std::clamp(std::exp(moved.x()), 1.0 / WidestFactor, WidestFactor);
  const double middle = MiddleOfOpacities(this->before);
  const double shift = -0.5 * range * moved.y();
  const Look scaled = ScaleLook(this->before, factor, middle);
  Look look = MoveNodes(scaled, AllNodes(scaled), shift, 0.0);
  look.regions = TransformedRegions(this->before.regions, factor, (1.0 - factor) * middle + shift);
  this->model->SetLook(look, tr("window and level"), this->gesture);
}

void BrightnessTool::Cancel()
{
  this->model->SetLook(this->before, tr("window and level"), this->gesture);
}

double MiddleOfOpacities(const Look& look)
{
  double first = look.opacities.front().value;
  double last = look.opacities.back().value;
  const auto varies = [](const OpacityNode& a, const OpacityNode& b)
  { return a.opacity != b.opacity; };
  const auto begin = std::adjacent_find(look.opacities.begin(), look.opacities.end(), varies);
  if (begin != look.opacities.end())
  {
    first = begin->value;
    last = std::adjacent_find(look.opacities.rbegin(), look.opacities.rend(), varies)->value;
  }
  return 0.5 * (first + last);
}

namespace
{

constexpr double PointPixels = 3.0;        // spacing of the points of an outline
constexpr double SmallestSidePixels = 6.0; // smaller outlines are taken for clicks

}

ScissorsTool::ScissorsTool(
  SceneModel* model, const ToolSurface& surface, const std::function<Camera()>& camera)
  : model(model)
  , surface(surface)
  , camera(camera)
{
}

bool ScissorsTool::Press(const QPointF& place)
{
  this->drawn = QPolygonF({ place });
  return true;
}

void ScissorsTool::Drag(const QPointF& place)
{
  if (QLineF(this->drawn.last(), place).length() >= PointPixels)
  {
    this->drawn.append(place);
  }
}

void ScissorsTool::Release(const QPointF& place)
{
  this->Drag(place);
  const QSizeF side = this->drawn.boundingRect().size();
  if (this->drawn.size() >= 3 && side.width() >= SmallestSidePixels &&
    side.height() >= SmallestSidePixels)
  {
    ScissorsCut cut;
    cut.camera = this->camera();
    cut.keepsInside = this->keepsInside;
    const QSizeF size = this->surface.Frame().size;
    const double half = 0.5 * size.height();
    for (const QPointF& point : this->drawn)
    {
      cut.outline.push_back({ (point.x() - 0.5 * size.width()) / half, 1.0 - point.y() / half });
    }
    this->model->Edit(ScenePart::Cuts, this->keepsInside ? tr("keep the inside") : tr("cut out"),
      [&](Scene& scene) { scene.cuts.scissors.push_back(cut); });
  }
  this->drawn.clear();
}

void ScissorsTool::Paint(QPainter& painter) const
{
  if (this->drawn.isEmpty())
  {
    return;
  }
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(QColor(0, 0, 0, 160), 4.0));
  painter.drawPolyline(this->drawn);
  painter.setPen(QPen(QColor(255, 110, 90), 2.0));
  painter.setBrush(QColor(255, 110, 90, 40));
  painter.drawPolygon(this->drawn);
}

namespace
{

constexpr int StepMs = 33;
constexpr double LongestStepSeconds = 0.25; // a slow frame must not carry the eye far
constexpr double DiagonalsPerSecond = 1.0 / 8.0;
constexpr double ShiftFactor = 4.0;
constexpr double SteepestDegrees = 85.0;

// To the right, up and forwards.
const std::map<int, glm::dvec3>& StepsOfKeys()
{
  static const std::map<int, glm::dvec3> steps = { { Qt::Key_W, { 0.0, 0.0, 1.0 } },
    { Qt::Key_Up, { 0.0, 0.0, 1.0 } }, { Qt::Key_S, { 0.0, 0.0, -1.0 } },
    { Qt::Key_Down, { 0.0, 0.0, -1.0 } }, { Qt::Key_A, { -1.0, 0.0, 0.0 } },
    { Qt::Key_Left, { -1.0, 0.0, 0.0 } }, { Qt::Key_D, { 1.0, 0.0, 0.0 } },
    { Qt::Key_Right, { 1.0, 0.0, 0.0 } }, { Qt::Key_E, { 0.0, 1.0, 0.0 } },
    { Qt::Key_PageUp, { 0.0, 1.0, 0.0 } }, { Qt::Key_Q, { 0.0, -1.0, 0.0 } },
    { Qt::Key_PageDown, { 0.0, -1.0, 0.0 } } };
  return steps;
}

/// The axes of a view, unit vectors across each other.
struct ViewAxes
{
  glm::dvec3 right;
  glm::dvec3 up;
  glm::dvec3 forward;
};

ViewAxes AxesOf(const CameraPose& pose)
{
  const glm::dvec3 forward =
    glm::normalize(VectorOf(pose.focalPointMm) - VectorOf(pose.positionMm));
  const glm::dvec3 right = glm::normalize(glm::cross(forward, VectorOf(pose.viewUp)));
  return { right, glm::cross(right, forward), forward };
}

}

WalkTool::WalkTool(SceneModel* model, const ToolSurface& surface, std::function<Camera()> camera)
  : model(model)
  , surface(surface)
  , camera(std::move(camera))
{
  this->timer.setInterval(StepMs);
  QObject::connect(&this->timer, &QTimer::timeout, [this] { this->Step(); });
}

bool WalkTool::TakeKey(QKeyEvent* event)
{
  const bool isPlain = (event->modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) == 0;
  if (StepsOfKeys().count(event->key()) == 0 || !isPlain)
  {
    return false;
  }
  event->accept();
  if (event->type() == QEvent::ShortcutOverride || event->isAutoRepeat())
  {
    return true;
  }
  if (event->type() == QEvent::KeyRelease)
  {
    this->held.erase(event->key());
    return true;
  }
  if (this->held.empty())
  {
    this->gesture = NewGesture();
    this->sinceStep.start();
    this->timer.start();
  }
  this->held[event->key()] = (event->modifiers() & Qt::ShiftModifier) != 0;
  return true;
}

void WalkTool::Stand()
{
  this->held.clear();
}

void WalkTool::Step()
{
  if (this->held.empty())
  {
    this->timer.stop();
    return;
  }
  const double seconds =
    std::min(1e-9 * double(this->sinceStep.nsecsElapsed()), LongestStepSeconds);
  this->sinceStep.start();
  const double diagonalMm = this->model->CurrentStudy()->volume.image->GetLength();
  glm::dvec3 step(0.0);
  for (const auto& [key, isFast] : this->held)
  {
    step += (isFast ? ShiftFactor : 1.0) * StepsOfKeys().at(key);
  }
  Camera placement = WithProjection(this->camera(), false);
  placement.pose = Walked(*placement.pose, diagonalMm * DiagonalsPerSecond * seconds * step);
  this->Place(placement);
}

void WalkTool::Place(const Camera& placement)
{
  this->model->Edit(
    ScenePart::Camera, tr("walk"), [&](Scene& scene) { scene.camera = placement; }, this->gesture);
}

bool WalkTool::Press(const QPointF& place)
{
  this->pressed = place;
  this->before = this->camera();
  if (this->held.empty())
  {
    this->gesture = NewGesture();
  }
  return true;
}

// The view turns by its own angle in a drag over its height.
void WalkTool::Drag(const QPointF& place)
{
  const Camera present = WithProjection(this->camera(), false);
  const double degreesPerPixel = present.viewAngleDegrees / this->surface.Frame().size.height();
  const QPointF moved = degreesPerPixel * (place - this->pressed);
  this->pressed = place;
  Camera placement = present;
  placement.pose = LookingAround(*present.pose, moved.x(), -moved.y());
  this->Place(placement);
}

void WalkTool::Cancel()
{
  this->Place(this->before);
}

CameraPose Walked(const CameraPose& pose, const glm::dvec3& stepMm)
{
  const ViewAxes axes = AxesOf(pose);
  const glm::dvec3 moved = stepMm.x * axes.right + stepMm.y * axes.up + stepMm.z * axes.forward;
  CameraPose walked = pose;
  walked.positionMm = NumbersOf(VectorOf(pose.positionMm) + moved);
  walked.focalPointMm = NumbersOf(VectorOf(pose.focalPointMm) + moved);
  return walked;
}

CameraPose LookingAround(const CameraPose& pose, double rightwardsDegrees, double upwardsDegrees)
{
  const glm::dvec3 eye = VectorOf(pose.positionMm);
  const glm::dvec3 upright = glm::normalize(VectorOf(pose.viewUp));
  const ViewAxes axes = AxesOf(pose);
  const double height = std::clamp(glm::dot(axes.forward, upright), -1.0, 1.0);
  const double presentDegrees = glm::degrees(std::asin(height));
  const double steepest = std::max(SteepestDegrees, std::abs(presentDegrees));
  const double degrees =
    std::clamp(presentDegrees + upwardsDegrees, -steepest, steepest) - presentDegrees;
  const glm::dmat4 sideways =
    glm::rotate(glm::dmat4(1.0), -glm::radians(rightwardsDegrees), upright);
  const glm::dmat4 turn = glm::rotate(sideways, glm::radians(degrees), axes.right);
  const glm::dvec3 turned(turn * glm::dvec4(axes.forward, 0.0));
  CameraPose looking = pose;
  looking.focalPointMm = NumbersOf(eye + glm::distance(VectorOf(pose.focalPointMm), eye) * turned);
  return looking;
}

}
