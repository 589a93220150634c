#include "Viewer/View/SliceView.h"

#include "Scene/Model/Scene.h"
#include "Scene/Model/SceneCuts.h"
#include "Scene/Model/WorldVector.h"
#include "Scene/Pipeline/ScenePicking.h"
#include "Scene/Slices/SliceFusing.h"
#include "Scene/Slices/SlicePicture.h"
#include "Scene/Volumes/Placing.h"
#include "Viewer/Model/SliceWindows.h"
#include "Viewer/View/Overlay.h"

#include <QColor>
#include <QImage>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <QWidget>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace varimarch
{

namespace
{

constexpr double SliceZoomPerNotch = 1.15;

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
  this->zoom.factor =
    std::clamp(this->zoom.factor * std::pow(SliceZoomPerNotch, notches), 0.2, 50.0);
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

// The part of SliceView that draws.

namespace
{

const QColor CrosshairColor(90, 200, 250, 170);

}

void SliceView::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.fillRect(this->rect(), Qt::black);
  if (!this->model->CurrentStudy() || (this->turns && this->turns->Awaits(this)))
  {
    return;
  }
  this->DrawVoxels(painter);
  this->DrawCrosshair(painter);
  const std::vector<QRectF> taken =
    DrawSliceCorners(painter, this->rect(), this->model->CurrentStudy()->volume.image,
      { this->Request(), this->zoom.factor, this->corners });
  this->DrawMeasuresOfSlice(painter, taken);
  this->DrawBrush(painter);
  if (this->hasFocus())
  {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(CrosshairColor);
    painter.drawRect(QRectF(this->rect()).adjusted(0.5, 0.5, -0.5, -0.5));
  }
}

void SliceView::DrawVoxels(QPainter& painter) const
{
  // Render at the resolution of the screen.
  SliceRequest request = this->Request();
  const double ratio = this->devicePixelRatioF();
  request.width = std::max(int(request.width * ratio), 1);
  request.height = std::max(int(request.height * ratio), 1);
  request.mmPerPixel /= ratio;
  const Study& study = *this->model->CurrentStudy();
  const std::vector<std::uint8_t> grays = SlicePicture(study.volume.image, request);
  painter.drawImage(this->rect(),
    QImage(grays.data(), request.width, request.height, request.width, QImage::Format_Grayscale8));
  this->DrawOverlays(painter, request);
  this->DrawSegments(painter, request);
}

// Segments lie over all volumes. Those of a hidden volume are hidden with it.
void SliceView::DrawSegments(QPainter& painter, const SliceRequest& request) const
{
  const Scene& scene = this->model->CurrentScene();
  for (int volume = 0; volume < VolumeCount(scene); ++volume)
  {
    const auto& labels = SceneLabelsOf(scene, volume);
    if (labels && (volume == 0 || scene.overlays[volume - 1].visible))
    {
      const auto numbers = Placed(StudyOfVolume(*this->model->CurrentStudy(), volume).labels->image,
        PlacementOf(scene, volume));
      const std::vector<Rgba> colors = SliceSegments(numbers, labels->segments, request);
      painter.drawImage(this->rect(),
        QImage(colors.data()->data(), request.width, request.height, QImage::Format_RGBA8888));
    }
  }
}

void SliceView::DrawOverlays(QPainter& painter, SliceRequest request) const
{
  const Scene& scene = this->model->CurrentScene();
  for (std::size_t i = 0; i < scene.overlays.size(); ++i)
  {
    const OverlaidVolume& overlay = scene.overlays[i];
    const Study& study = *this->model->CurrentStudy()->overlays[i];
    if (!overlay.visible)
    {
      continue;
    }
    // A blend shows PET bright on dark, whatever its slices look like alone.
    const auto windowLevel =
      overlay.windowLevel.value_or(SuggestedGrays(study.volume, study.statistics).windowLevel);
    request.window = windowLevel[0];
    request.level = windowLevel[1];
    request.inverted = false;
    const bool isBlend = scene.slices.fusion == SliceFusion::Blend;
    const std::vector<Rgba> pixels =
      FusedPixels(Placed(study.volume.image, overlay.placement), request,
        { overlay.sliceColors, isBlend ? scene.slices.fusionOpacity * overlay.opacity : 1.0,
          scene.slices.fusion });
    painter.drawImage(this->rect(),
      QImage(pixels.data()->data(), request.width, request.height, QImage::Format_RGBA8888));
  }
}

void SliceView::DrawMeasuresOfSlice(QPainter& painter, const std::vector<QRectF>& taken) const
{
  painter.setRenderHint(QPainter::Antialiasing);
  DrawMeasures(painter,
    { this->model->CurrentScene(), this->texts, this->model->CurrentStudy()->volume.image },
    this->Frame(),
    { [this](const auto& points) { return this->Shows(points); }, [](const auto&) { return false; },
      taken });
  this->measure.Paint(painter);
}

void SliceView::DrawCrosshair(QPainter& painter) const
{
  const double far = std::hypot(this->width(), this->height());
  const CrosshairArms arms = this->Arms();
  painter.setPen(CrosshairColor);
  for (const QPointF& along : arms.Directions())
  {
    painter.drawLine(arms.Middle() - far * along, arms.Middle() + far * along);
  }
}

void SliceView::DrawBrush(QPainter& painter) const
{
  if (this->segmentEditor && this->segmentEditor->IsBrush() && this->underMouse())
  {
    const double radius = this->segmentEditor->RadiusMm() / this->Placement().MmPerPixel();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(CrosshairColor);
    painter.drawEllipse(this->pointer, radius, radius);
  }
}

// The part of SliceView that knows which point of the patient is where.

PictureFrame SliceView::Frame() const
{
  const SliceAxes axes = this->Axes();
  const glm::dvec3 through = VectorOf(axes.through);
  const auto sightLineAt = [this, through](const QPointF& place)
  {
    const glm::dvec3 point = VectorOf(*this->PointAt(place));
    return SightLine{ point - through, point + through };
  };
  return { this->size(),
    [this](const std::array<double, 3>& point) { return std::optional(this->PlaceOf(point)); },
    sightLineAt, axes.right, NumbersOf(-VectorOf(axes.down)), NumbersOf(-through) };
}

std::optional<glm::dvec3> SliceView::Through() const
{
  return VectorOf(this->Axes().through);
}

// True for objects that reach into the slab, or within half a voxel of a single slice.
bool SliceView::Shows(const std::vector<glm::dvec3>& points) const
{
  const double* const spacing = this->model->CurrentStudy()->volume.image->GetSpacing();
  const double reachMm = 0.5 *
    std::max(this->model->CurrentScene().slices.slabMm, *std::max_element(spacing, spacing + 3));
  const glm::dvec3 through = VectorOf(this->Axes().through);
  const double crosshairMm = glm::dot(VectorOf(this->Crosshair()), through);
  double first = std::numeric_limits<double>::infinity();
  double last = -first;
  for (const glm::dvec3& point : points)
  {
    const double depth = glm::dot(point, through) - crosshairMm;
    first = std::min(first, depth);
    last = std::max(last, depth);
  }
  return first <= reachMm && last >= -reachMm;
}

void SliceView::AskForWords(const QPointF& place, const std::function<void(const QString&)>& take)
{
  AskForWordsOver(this, place, take);
}

std::optional<std::array<double, 3>> SliceView::PointAt(const QPointF& place) const
{
  return this->Placement().PointAt(place);
}

QPointF SliceView::PlaceOf(const std::array<double, 3>& pointMm) const
{
  return this->Placement().PlaceOf(pointMm);
}

SliceRequest SliceView::Request() const
{
  const SlicePlacement placement = this->Placement();
  const SliceGrays grays = this->Grays();
  const SliceSettings& slices = this->model->CurrentScene().slices;
  return { this->plane, placement.MiddleMm(), placement.MmPerPixel(), this->width(), this->height(),
    grays.windowLevel[0], grays.windowLevel[1], slices.slabMm, slices.slabBlend, grays.inverted,
    slices.turn };
}

SlicePlacement SliceView::Placement() const
{
  return { this->model->CurrentStudy()->volume.image, this->Axes(), this->Crosshair(), this->size(),
    this->zoom };
}

SliceAxes SliceView::Axes() const
{
  return AxesOf(this->plane, this->model->CurrentScene().slices.turn);
}

CrosshairArms SliceView::Arms() const
{
  return { this->plane, this->model->CurrentScene().slices.turn, this->Placement(),
    this->Crosshair(), this->size() };
}

std::array<double, 3> SliceView::Crosshair() const
{
  return this->model->CurrentScene().slices.crosshairMm.value_or(
    MiddleOf(this->model->CurrentStudy()->volume.image));
}

SliceGrays SliceView::Grays() const
{
  const auto study = this->model->CurrentStudy();
  SliceGrays grays = SuggestedGrays(study->volume, study->statistics);
  grays.windowLevel = this->model->CurrentScene().slices.windowLevel.value_or(grays.windowLevel);
  return grays;
}

void SliceView::SetCrosshair(const std::array<double, 3>& pointMm, int ofGesture)
{
  this->model->Edit(
    ScenePart::Slices, tr("move the crosshair"),
    [&](Scene& scene) { scene.slices.crosshairMm = pointMm; }, ofGesture);
}

DrawingTurns::DrawingTurns(QObject* parent)
  : QObject(parent)
{
  this->turn.setSingleShot(true);
  connect(&this->turn, &QTimer::timeout, this, &DrawingTurns::PaintNext);
}

void DrawingTurns::Await(QWidget* widget)
{
  if (!this->Awaits(widget))
  {
    this->queue.push_back(widget);
    this->turn.start(0);
  }
}

bool DrawingTurns::Awaits(const QWidget* widget) const
{
  return std::find(this->queue.begin(), this->queue.end(), widget) != this->queue.end();
}

void DrawingTurns::PaintNext()
{
  const QPointer<QWidget> next = this->queue.front();
  this->queue.pop_front();
  if (!this->queue.empty())
  {
    this->turn.start(0);
  }
  if (next)
  {
    next->repaint();
  }
}

}
