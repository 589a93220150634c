#include "Viewer/View/SliceView.h"

#include "Scene/AnatomicalDirection.h"
#include "Scene/SceneCuts.h"
#include "Scene/ScenePicking.h"
#include "Scene/SliceSegments.h"
#include "Scene/WorldVector.h"
#include "Viewer/Model/NumberText.h"
#include "Viewer/View/MeasureOverlay.h"

#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

constexpr double ZoomPerNotch = 1.15;
const QColor CrosshairColor(90, 200, 250, 170);

QString LettersOf(const glm::dvec3& direction)
{
  return QString::fromStdString(AnatomicalDirection(&direction.x));
}

}

SliceView::SliceView(SceneModel* model, SlicePlane plane, QWidget* parent)
  : QWidget(parent)
  , model(model)
  , plane(plane)
  , axes(AxesOf(plane))
  , measure(model, *this)
{
  this->setMinimumSize(120, 90);
  this->setAttribute(Qt::WA_OpaquePaintEvent);
  this->setCursor(Qt::CrossCursor);
  this->setMouseTracking(true);
  connect(model, &SceneModel::Changed, this, &SliceView::Update);
}

void SliceView::Update(ScenePart part)
{
  if (part == ScenePart::Volume || part == ScenePart::Measures)
  {
    this->texts = MeasureTexts(this->model->CurrentScene(), this->model->CurrentStudy()->volume);
    this->update();
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

PictureFrame SliceView::Frame() const
{
  const glm::dvec3 through = VectorOf(this->axes.through);
  const auto sightLineAt = [this, through](const QPointF& place)
  {
    const glm::dvec3 point = VectorOf(*this->PointAt(place));
    return SightLine{ point - through, point + through };
  };
  return { this->size(),
    [this](const std::array<double, 3>& point) { return std::optional(this->PlaceOf(point)); },
    sightLineAt, this->axes.right, NumbersOf(-VectorOf(this->axes.down)), NumbersOf(-through) };
}

std::optional<glm::dvec3> SliceView::Through() const
{
  return VectorOf(this->axes.through);
}

// True for objects that reach into the slab, or within half a voxel of a single slice.
bool SliceView::Shows(const std::array<double, 3>& from, const std::array<double, 3>& to) const
{
  const double* const spacing = this->model->CurrentStudy()->volume.image->GetSpacing();
  const double reachMm = 0.5 *
    std::max(this->model->CurrentScene().slices.slabMm, *std::max_element(spacing, spacing + 3));
  const auto depth = [this](const std::array<double, 3>& point)
  { return glm::dot(VectorOf(point) - VectorOf(this->Crosshair()), VectorOf(this->axes.through)); };
  const auto [first, last] = std::minmax({ depth(from), depth(to) });
  return first <= reachMm && last >= -reachMm;
}

std::optional<std::array<double, 3>> SliceView::PointAt(const QPointF& place) const
{
  const QPointF fromMiddle = place - QRectF(this->rect()).center();
  // The view does not scroll when the crosshair moves within it.
  glm::dvec3 point = VectorOf(this->Request().middleMm);
  point += this->MmPerPixel() * fromMiddle.x() * VectorOf(this->axes.right);
  point += this->MmPerPixel() * fromMiddle.y() * VectorOf(this->axes.down);
  return NumbersOf(point);
}

QPointF SliceView::PlaceOf(const std::array<double, 3>& pointMm) const
{
  const glm::dvec3 fromMiddle = VectorOf(pointMm) - VectorOf(this->Request().middleMm);
  return QRectF(this->rect()).center() +
    QPointF(glm::dot(fromMiddle, VectorOf(this->axes.right)),
      glm::dot(fromMiddle, VectorOf(this->axes.down))) /
    this->MmPerPixel();
}

void SliceView::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.fillRect(this->rect(), Qt::black);
  if (!this->model->CurrentStudy())
  {
    return;
  }
  this->DrawVoxels(painter);
  this->DrawCrosshair(painter);
  this->DrawLetters(painter);
  this->DrawMeasuresOfSlice(painter);
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
  if (const auto& labels = this->model->CurrentScene().labels)
  {
    const std::vector<Rgba> colors = SliceSegments(study.labels->image, labels->segments, request);
    painter.drawImage(this->rect(),
      QImage(colors.data()->data(), request.width, request.height, QImage::Format_RGBA8888));
  }
}

void SliceView::DrawMeasuresOfSlice(QPainter& painter) const
{
  painter.setRenderHint(QPainter::Antialiasing);
  DrawMeasures(painter,
    { this->model->CurrentScene(), this->texts, this->model->CurrentStudy()->volume.image },
    this->Frame(),
    { [this](const auto& from, const auto& to) { return this->Shows(from, to); },
      [](const auto&) { return false; } });
  this->measure.Paint(painter);
}

void SliceView::DrawCrosshair(QPainter& painter) const
{
  const QPointF place = this->PlaceOf(this->Crosshair());
  painter.setPen(CrosshairColor);
  painter.drawLine(QPointF(0.0, place.y()), QPointF(this->width(), place.y()));
  painter.drawLine(QPointF(place.x(), 0.0), QPointF(place.x(), this->height()));
}

void SliceView::DrawLetters(QPainter& painter) const
{
  const glm::dvec3 right = VectorOf(this->axes.right);
  const glm::dvec3 down = VectorOf(this->axes.down);
  const QRect inside = this->rect().adjusted(6, 4, -6, -4);
  DrawLegibly(painter, inside, Qt::AlignRight | Qt::AlignVCenter, LettersOf(right));
  DrawLegibly(painter, inside, Qt::AlignLeft | Qt::AlignVCenter, LettersOf(-right));
  DrawLegibly(painter, inside, Qt::AlignBottom | Qt::AlignHCenter, LettersOf(down));
  DrawLegibly(painter, inside, Qt::AlignTop | Qt::AlignHCenter, LettersOf(-down));
  const auto [window, level] = this->Grays().windowLevel;
  // Data without units may lie between 0 and 1.
  const int decimals = window < 10.0 ? 3 : 0;
  DrawLegibly(painter, inside, Qt::AlignLeft | Qt::AlignTop,
    tr("W %1 L %2").arg(NumberText(window, decimals), NumberText(level, decimals)));
}

void SliceView::mousePressEvent(QMouseEvent* event)
{
  if (!this->model->CurrentStudy())
  {
    return;
  }
  this->gesture = NewGesture();
  this->pressed = event->pos();
  this->pressedWindowLevel = this->Grays().windowLevel;
  this->toolIsActive =
    this->measuring && event->button() == Qt::LeftButton && this->measure.Press(event->localPos());
  if (!this->toolIsActive && event->button() == Qt::LeftButton)
  {
    this->SetCrosshair(*this->PointAt(event->localPos()), this->gesture);
  }
}

void SliceView::mouseReleaseEvent(QMouseEvent* event)
{
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
  this->Point(event->localPos());
  if (this->toolIsActive)
  {
    this->measure.Drag(event->localPos());
    this->update();
  }
  else if (event->buttons() & Qt::LeftButton)
  {
    this->SetCrosshair(*this->PointAt(event->localPos()), this->gesture);
  }
  else if (event->buttons() & Qt::RightButton)
  {
    this->DragWindowLevel(event->pos() - this->pressed);
  }
}

void SliceView::Point(const QPointF& place)
{
  const std::array<double, 3> point = *this->PointAt(place);
  const Study& study = *this->model->CurrentStudy();
  emit this->Pointed(ValueAt(study.volume.image, point)
      ? PointText(this->model->CurrentScene(), study, point)
      : QString());
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

void SliceView::wheelEvent(QWheelEvent* event)
{
  if (!this->model->CurrentStudy())
  {
    return;
  }
  const double notches = event->angleDelta().y() / 120.0;
  if (event->modifiers() & Qt::ControlModifier)
  {
    this->zoom = std::clamp(this->zoom * std::pow(ZoomPerNotch, notches), 0.2, 50.0);
    this->update();
    return;
  }
  const double* const spacing = this->model->CurrentStudy()->volume.image->GetSpacing();
  const double stepMm = std::min({ spacing[0], spacing[1], spacing[2] });
  this->SetCrosshair(
    NumbersOf(VectorOf(this->Crosshair()) + notches * stepMm * VectorOf(this->axes.through)),
    SceneModel::NoGesture);
}

SliceRequest SliceView::Request() const
{
  vtkImageData* const image = this->model->CurrentStudy()->volume.image;
  // The view is centred on the volume, in the plane of the crosshair.
  const glm::dvec3 middle = VectorOf(MiddleOf(image));
  const glm::dvec3 through = VectorOf(this->axes.through);
  const glm::dvec3 shown =
    middle + glm::dot(VectorOf(this->Crosshair()) - middle, through) * through;
  const SliceGrays grays = this->Grays();
  const SliceSettings& slices = this->model->CurrentScene().slices;
  return { this->plane, NumbersOf(shown), this->MmPerPixel(), this->width(), this->height(),
    grays.windowLevel[0], grays.windowLevel[1], slices.slabMm, slices.slabBlend, grays.inverted };
}

// At a zoom of 1 the volume just fits into the view.
double SliceView::MmPerPixel() const
{
  vtkImageData* const image = this->model->CurrentStudy()->volume.image;
  const auto acrossMm = [&](const std::array<double, 3>& direction)
  {
    const auto [first, last] = ReachAlong(direction, image);
    return last - first;
  };
  return std::max(acrossMm(this->axes.right) / std::max(this->width(), 1),
           acrossMm(this->axes.down) / std::max(this->height(), 1)) /
    this->zoom;
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

}
