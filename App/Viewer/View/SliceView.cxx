#include "Viewer/View/SliceView.h"

#include "Scene/SceneCuts.h"
#include "Scene/ScenePicking.h"
#include "Scene/SliceNumber.h"
#include "Scene/WorldVector.h"
#include "Viewer/Model/SliceWindows.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace varimarch
{

namespace
{

constexpr double ZoomPerNotch = 1.15;

}

SliceView::SliceView(SceneModel* model, SlicePlane plane, QWidget* parent)
  : QWidget(parent)
  , model(model)
  , plane(plane)
  , measure(model, *this)
{
  this->setMinimumSize(120, 90);
  this->setAttribute(Qt::WA_OpaquePaintEvent);
  this->setCursor(Qt::CrossCursor);
  this->setMouseTracking(true);
  this->setFocusPolicy(Qt::StrongFocus);
  connect(model, &SceneModel::Changed, this, &SliceView::Update);
  if (model->CurrentStudy())
  {
    this->Update(ScenePart::Volume);
  }
}

void SliceView::Update(ScenePart part)
{
  if (part == ScenePart::Volume)
  {
    this->zoom = {};
    this->measure.Forget();
  }
  if (part == ScenePart::Volume || part == ScenePart::Voxels || part == ScenePart::Measures ||
    part == ScenePart::Overlays)
  {
    this->texts = this->model->Texts();
    if (part == ScenePart::Volume && this->turns)
    {
      this->turns->Await(this);
    }
    else
    {
      this->update();
    }
  }
  if (part == ScenePart::Slices || part == ScenePart::Labels || part == ScenePart::Segments)
  {
    this->update();
  }
}

void SliceView::SetTool(LeftButton button)
{
  const std::optional<MeasureKind> kind = MeasureOf(button);
  this->measuring = bool(kind);
  this->measure.SetKind(kind.value_or(MeasureKind::Distance));
}

void SliceView::SetCornerTexts(const CornerTexts& shown)
{
  this->corners = shown;
  this->update();
}

void SliceView::SetSegmentEditor(SegmentEditor* newEditor)
{
  this->segmentEditor = newEditor;
  for (const auto signal : { &SegmentEditor::Stroked, &SegmentEditor::ToolChanged })
  {
    connect(newEditor, signal, this, QOverload<>::of(&SliceView::update));
  }
}

// True if the press edits segments. Other buttons do nothing during a stroke.
bool SliceView::PressSegment(const QMouseEvent* event)
{
  if (event->button() == Qt::LeftButton && this->Draws())
  {
    this->isDrawing = true;
    this->segmentEditor->Press(*this->PointAt(event->localPos()), this->Axes().through);
  }
  return this->isDrawing;
}

bool SliceView::Draws() const
{
  return this->segmentEditor && this->segmentEditor->TakesSlices();
}

void SliceView::mousePressEvent(QMouseEvent* event)
{
  if (!this->model->CurrentStudy())
  {
    return;
  }
  if (this->PressSegment(event))
  {
    return;
  }
  this->gesture = NewGesture();
  this->pressed = event->pos();
  this->pressedWindowLevel = this->Grays().windowLevel;
  this->pressedShiftMm = this->zoom.shiftMm;
  this->toolIsActive =
    this->measuring && event->button() == Qt::LeftButton && this->measure.Press(event->localPos());
  if (this->toolIsActive || event->button() != Qt::LeftButton)
  {
    return;
  }
  if (const CrosshairArms arms = this->Arms(); arms.Hold(event->localPos()))
  {
    this->draggedArms = arms;
    return;
  }
  this->SetCrosshair(*this->PointAt(event->localPos()), this->gesture);
}

void SliceView::mouseReleaseEvent(QMouseEvent* event)
{
  if (event->button() == Qt::LeftButton && this->draggedArms)
  {
    this->draggedArms.reset();
    if (event->pos() == this->pressed) // a click on an arm is one into the slice
    {
      this->SetCrosshair(*this->PointAt(event->localPos()), this->gesture);
    }
  }
  if (event->button() == Qt::LeftButton && std::exchange(this->isDrawing, false))
  {
    this->segmentEditor->Release();
  }
  if (this->toolIsActive && event->button() == Qt::LeftButton)
  {
    this->toolIsActive = false;
    this->measure.Release(event->localPos());
    this->update();
  }
}

void SliceView::mouseMoveEvent(QMouseEvent* event)
{
  if (!this->model->CurrentStudy())
  {
    return;
  }
  this->FollowPointer(event->localPos());
  if (this->isDrawing)
  {
    this->segmentEditor->Drag(*this->PointAt(event->localPos()));
  }
  else if (this->toolIsActive)
  {
    this->measure.Drag(event->localPos());
    this->update();
  }
  else if (this->draggedArms)
  {
    const SliceTurn turn = this->draggedArms->Dragged(this->pressed, event->localPos());
    this->model->Edit(
      ScenePart::Slices, tr("turn the slices"), [&](Scene& scene) { scene.slices.turn = turn; },
      this->gesture);
  }
  else if (event->buttons() & Qt::LeftButton)
  {
    this->SetCrosshair(*this->PointAt(event->localPos()), this->gesture);
  }
  else if (event->buttons() & Qt::RightButton)
  {
    this->DragWindowLevel(event->pos() - this->pressed);
  }
  else if (event->buttons() & Qt::MiddleButton)
  {
    this->DragSlice(event->pos() - this->pressed);
  }
}

void SliceView::FollowPointer(const QPointF& place)
{
  this->pointer = place;
  const std::array<double, 3> point = *this->PointAt(place);
  const Study& study = *this->model->CurrentStudy();
  emit this->Pointed(ValueAt(study.volume.image, point)
      ? PointText(this->model->CurrentScene(), study, point)
      : QString());
  const bool isBrush = this->segmentEditor && this->segmentEditor->IsBrush();
  const bool turns =
    this->draggedArms || (!this->measuring && !this->Draws() && this->Arms().Hold(place));
  this->setCursor(turns ? Qt::PointingHandCursor : Qt::CrossCursor);
  if (isBrush)
  {
    this->update(); // the brush follows
  }
}

// Dragging to the right widens the window, dragging down brightens, as in radiology viewers.
void SliceView::DragWindowLevel(const QPoint& moved)
{
  const ImageStatistics& statistics = this->model->CurrentStudy()->statistics;
  const double perPixel = (statistics.Percentile(99.9) - statistics.Percentile(0.1)) / 1000.0;
  const std::array<double, 2> changed = {
    std::max(this->pressedWindowLevel[0] + perPixel * moved.x(), perPixel),
    this->pressedWindowLevel[1] - perPixel * moved.y(),
  };
  this->model->Edit(
    ScenePart::Slices, tr("window and level"),
    [&](Scene& scene) { scene.slices.windowLevel = changed; }, this->gesture);
}

void SliceView::DragSlice(const QPoint& moved)
{
  this->zoom.shiftMm = this->pressedShiftMm - this->Placement().MmPerPixel() * QPointF(moved);
  this->update();
}

void SliceView::mouseDoubleClickEvent(QMouseEvent* event)
{
  if (this->measuring || this->Draws() || event->button() != Qt::LeftButton)
  {
    this->mousePressEvent(event);
    return;
  }
  emit this->DoubleClicked();
}

void SliceView::wheelEvent(QWheelEvent* event)
{
  if (!this->model->CurrentStudy())
  {
    return;
  }
  const double notches = event->angleDelta().y() / 120.0;
  event->modifiers() & Qt::ControlModifier ? this->Zoom(notches) : this->Scroll(notches);
}

// The window's shortcuts, such as the numbers of standard views, wait while a slice has the keys.
bool SliceView::event(QEvent* event)
{
  if (event->type() == QEvent::ShortcutOverride)
  {
    const auto* const key = static_cast<QKeyEvent*>(event);
    const bool isNumber = key->key() >= Qt::Key_0 && key->key() <= Qt::Key_9;
    if (isNumber && !(key->modifiers() & ~Qt::KeypadModifier))
    {
      event->accept();
      return true;
    }
  }
  return QWidget::event(event);
}

void SliceView::keyPressEvent(QKeyEvent* event)
{
  constexpr double Page = 10.0; // slices
  static const std::map<int, double> scrolls = { { Qt::Key_Up, 1.0 }, { Qt::Key_Down, -1.0 },
    { Qt::Key_PageUp, Page }, { Qt::Key_PageDown, -Page } };
  static const std::map<int, double> zooms = { { Qt::Key_Plus, 1.0 }, { Qt::Key_Equal, 1.0 },
    { Qt::Key_Minus, -1.0 } };
  const int key = event->key();
  if (!this->model->CurrentStudy())
  {
    QWidget::keyPressEvent(event);
  }
  else if (const auto scroll = scrolls.find(key); scroll != scrolls.end())
  {
    this->Scroll(scroll->second);
  }
  else if (const auto step = zooms.find(key); step != zooms.end())
  {
    this->Zoom(step->second);
  }
  else if (key == Qt::Key_Home)
  {
    this->ResetZoom();
  }
  else if (key >= Qt::Key_0 && key <= Qt::Key_9)
  {
    ChooseWindow(this->model, key - Qt::Key_0);
  }
  else
  {
    QWidget::keyPressEvent(event);
  }
}

void SliceView::Zoom(double notches)
{
  this->zoom.factor = std::clamp(this->zoom.factor * std::pow(ZoomPerNotch, notches), 0.2, 50.0);
  this->update();
}

void SliceView::ResetZoom()
{
  this->zoom = {};
  this->update();
}

void SliceView::Scroll(double slices)
{
  const double stepMm = SliceStepMm(this->model->CurrentStudy()->volume.image, this->plane);
  this->SetCrosshair(
    NumbersOf(VectorOf(this->Crosshair()) + slices * stepMm * VectorOf(this->Axes().through)),
    SceneModel::NoGesture);
}

}
