#include "Viewer/View/CurvedView.h"

#include "Scene/Model/SceneCuts.h"
#include "Scene/Model/WorldVector.h"
#include "Scene/Slices/SlicePicture.h"
#include "Viewer/Model/MeasureTexts.h"
#include "Viewer/View/Overlay.h"
#include "Viewer/View/SliceCorners.h"

#include <QAction>
#include <QActionGroup>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QSettings>
#include <QWheelEvent>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace varimarch
{

namespace
{

const QColor PlaceColor(90, 200, 250, 170);
constexpr double DegreesPerNotch = 5.0;
constexpr double LeastHeightMm = 60.0; // twice the diameter of an aorta
const char* const StretchedKey = "curve/stretched";

// The last visible curve of a scene, if it has a length.
std::optional<CurvePath> ShownCurve(const Scene& scene)
{
  const auto shown = std::find_if(scene.measures.rbegin(), scene.measures.rend(),
    [](const Measure& measure) { return measure.kind == MeasureKind::Curve && measure.visible; });
  if (shown == scene.measures.rend())
  {
    return std::nullopt;
  }
  CurvePath path(shown->pointsMm);
  return path.LengthMm() > 0.0 ? std::optional(std::move(path)) : std::nullopt;
}

}

CurvedView::CurvedView(SceneModel* model, QWidget* parent)
  : QWidget(parent)
  , model(model)
  , stretched(QSettings().value(StretchedKey).toBool())
{
  this->MakeMenu();
  this->setMinimumSize(200, 120);
  this->setAttribute(Qt::WA_OpaquePaintEvent);
  this->setCursor(Qt::CrossCursor);
  this->setMouseTracking(true);
  this->setFocusPolicy(Qt::StrongFocus);
  this->setAccessibleName(tr("Volume along the curve"));
  connect(model, &SceneModel::Changed, this, &CurvedView::Update);
  if (model->CurrentStudy())
  {
    this->Update(ScenePart::Volume);
  }
}

void CurvedView::MakeMenu()
{
  auto* const choices = new QActionGroup(this);
  const std::pair<const char*, QString> actions[] = { { "straightenedCurve", tr("Straightened") },
    { "stretchedCurve", tr("Stretched") } };
  for (int isStretched = 0; isStretched < 2; ++isStretched)
  {
    auto* const action = new QAction(actions[isStretched].second, choices);
    action->setObjectName(actions[isStretched].first);
    action->setCheckable(true);
    action->setChecked(this->stretched == bool(isStretched));
    connect(action, &QAction::triggered, this, [=] { this->SetStretched(isStretched); });
    this->addAction(action);
  }
  this->setContextMenuPolicy(Qt::ActionsContextMenu);
  this->setToolTip(
    tr("The context menu chooses between the straightened and the stretched volume"));
}

void CurvedView::SetStretched(bool isStretched)
{
  this->stretched = isStretched;
  QSettings().setValue(StretchedKey, isStretched);
  this->FindCut();
}

void CurvedView::Update(ScenePart part)
{
  if (part == ScenePart::Volume || part == ScenePart::Measures)
  {
    this->path = ShownCurve(this->model->CurrentScene());
    this->FindCut();
  }
  if (part == ScenePart::Slices)
  {
    this->FindCut();
  }
  if (part == ScenePart::Voxels)
  {
    this->update();
  }
}

void CurvedView::FindCut()
{
  this->cut = this->path;
  if (this->path && this->stretched)
  {
    this->cut = this->path->Stretched(this->model->CurrentScene().slices.curveTurnDegrees);
  }
  this->update();
}

// The curve fills the view from left to right, unless the view is so low that little around a
// vessel would be seen: then it fills a part on the left. A stretched one has been turned already.
CurvedRequest CurvedView::Request() const
{
  const double lengthMm = this->cut->LengthMm();
  const double mmPerPixel =
    std::max(lengthMm / std::max(this->width(), 1), LeastHeightMm / std::max(this->height(), 1));
  const Scene& scene = this->model->CurrentScene();
  const Study& study = *this->model->CurrentStudy();
  const SliceGrays grays = SuggestedGrays(study.volume, study.statistics);
  const auto [window, level] = scene.slices.windowLevel.value_or(grays.windowLevel);
  return { mmPerPixel, std::max(int(std::lround(lengthMm / mmPerPixel)), 1), this->height(),
    this->stretched ? 0.0 : scene.slices.curveTurnDegrees,
    { window, level, scene.slices.slabMm, scene.slices.slabBlend, grays.inverted } };
}

std::optional<glm::dvec3> CurvedView::PointAt(const QPointF& place) const
{
  const bool isOnCurve = this->path && place.x() >= 0.0 && place.x() <= this->Request().width;
  return isOnCurve ? std::optional(PointInCurved(*this->cut, this->Request(), place.x(), place.y()))
                   : std::nullopt;
}

void CurvedView::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.fillRect(this->rect(), Qt::black);
  if (!this->path)
  {
    painter.setPen(QColor(160, 160, 160));
    painter.drawText(this->rect().adjusted(12, 8, -12, -8), Qt::AlignCenter | Qt::TextWordWrap,
      tr("Choose Annotate, Curve, and click along a vessel or the jaw in the slices."));
    return;
  }
  this->DrawVoxels(painter);
  painter.setRenderHint(QPainter::Antialiasing);
  this->DrawCrosshair(painter);
  this->DrawCurve(painter);
  this->DrawRuler(painter);
}

void CurvedView::DrawVoxels(QPainter& painter) const
{
  // Render at the resolution of the screen.
  CurvedRequest request = this->Request();
  const QRect place(0, 0, request.width, request.height);
  const double ratio = this->devicePixelRatioF();
  request.width = std::max(int(request.width * ratio), 1);
  request.height = std::max(int(request.height * ratio), 1);
  request.mmPerPixel /= ratio;
  const std::vector<std::uint8_t> grays =
    CurvedPicture(this->model->CurrentStudy()->volume.image, *this->cut, request);
  painter.drawImage(place,
    QImage(grays.data(), request.width, request.height, request.width, QImage::Format_Grayscale8));
}

// A stretched curve is not in the middle.
void CurvedView::DrawCurve(QPainter& painter) const
{
  if (!this->stretched)
  {
    return;
  }
  const double mmPerPixel = this->Request().mmPerPixel;
  QPolygonF line;
  for (std::size_t i = 0; i < this->path->Points().size(); ++i)
  {
    const double distanceMm = this->cut->LengthsMm()[i];
    const CurvePath::Place place = this->cut->At(distanceMm, 0.0);
    const double height = glm::dot(this->path->Points()[i] - place.pointMm, place.across);
    line.append({ distanceMm / mmPerPixel, 0.5 * this->height() - height / mmPerPixel });
  }
  painter.setPen(PlaceColor);
  painter.drawPolyline(line);
}

// Ticks at round distances along the curve, and the turn of the cut.
void CurvedView::DrawRuler(QPainter& painter) const
{
  constexpr double LargestPart = 0.2; // part of the curve's length between two ticks
  const double mmPerPixel = this->Request().mmPerPixel;
  const double stepMm = ScaleBarMm(LargestPart * this->cut->LengthMm());
  const double bottom = this->height() - 3.0;
  for (int tick = 0; tick * stepMm <= this->cut->LengthMm(); ++tick)
  {
    // A line at the edge would be half outside.
    const double x = std::clamp(tick * stepMm / mmPerPixel, 0.5, this->width() - 0.5);
    painter.setPen(QPen(Qt::white, 1.0));
    painter.drawLine(QPointF(x, bottom), QPointF(x, bottom - 6.0));
    const QString number = NumberText(tick * stepMm, stepMm < 1.0 ? 2 : 0);
    const double width = painter.fontMetrics().horizontalAdvance(number);
    const double left = x + 3.0 + width < this->width() ? x + 3.0 : x - 3.0 - width;
    DrawLegibly(painter, QRectF(left, bottom - 18.0, width + 1.0, 16.0),
      Qt::AlignLeft | Qt::AlignTop, number);
  }
  const SliceSettings& slices = this->model->CurrentScene().slices;
  QString text =
    tr("%1 mm, turned by %2°")
      .arg(NumberText(this->path->LengthMm(), 1), NumberText(slices.curveTurnDegrees, 0));
  if (this->stretched)
  {
    text += tr(", stretched");
  }
  if (slices.slabMm > 0.0)
  {
    text += tr(", slab %1 mm").arg(NumberText(slices.slabMm, 1));
  }
  DrawLegibly(painter, QRectF(this->rect()).adjusted(6.0, 4.0, -6.0, -4.0),
    Qt::AlignLeft | Qt::AlignTop, text);
}

// The place on the curve that is nearest to the crosshair.
void CurvedView::DrawCrosshair(QPainter& painter) const
{
  const auto crosshair = this->model->CurrentScene().slices.crosshairMm.value_or(
    varimarch::MiddleOf(this->model->CurrentStudy()->volume.image));
  const double x = this->cut->NearestMm(VectorOf(crosshair)) / this->Request().mmPerPixel;
  painter.setPen(PlaceColor);
  painter.drawLine(QPointF(x, 0.0), QPointF(x, this->height()));
}

void CurvedView::mousePressEvent(QMouseEvent* event)
{
  if (event->button() == Qt::LeftButton)
  {
    this->gesture = NewGesture();
    this->MoveCrosshair(event->localPos());
  }
}

void CurvedView::mouseMoveEvent(QMouseEvent* event)
{
  if (event->buttons() & Qt::LeftButton)
  {
    this->MoveCrosshair(event->localPos());
  }
  if (const std::optional<glm::dvec3> point = this->PointAt(event->localPos()))
  {
    emit this->Pointed(
      tr("%1 mm along the curve; %2")
        .arg(NumberText(this->AlongCurveMm(event->localPos().x()), 1),
          PointText(this->model->CurrentScene(), *this->model->CurrentStudy(), NumbersOf(*point))));
  }
}

// The length of the curve itself up to a column, which a stretched picture shows shortened.
double CurvedView::AlongCurveMm(double x) const
{
  const std::vector<double>& inCut = this->cut->LengthsMm();
  const std::vector<double>& inCurve = this->path->LengthsMm();
  const double distanceMm = this->Request().mmPerPixel * x;
  const auto upper = std::upper_bound(inCut.begin() + 1, inCut.end() - 1, distanceMm);
  const std::size_t i = std::size_t(upper - inCut.begin());
  const double spanMm = inCut[i] - inCut[i - 1];
  const double part = spanMm > 0.0 ? (distanceMm - inCut[i - 1]) / spanMm : 0.0;
  return glm::mix(inCurve[i - 1], inCurve[i], part);
}

void CurvedView::MoveCrosshair(const QPointF& place)
{
  if (const std::optional<glm::dvec3> point = this->PointAt(place))
  {
    this->model->Edit(
      ScenePart::Slices, tr("move the crosshair"),
      [&](Scene& scene) { scene.slices.crosshairMm = NumbersOf(*point); }, this->gesture);
  }
}

void CurvedView::wheelEvent(QWheelEvent* event)
{
  this->Turn(DegreesPerNotch * event->angleDelta().y() / 120.0);
}

void CurvedView::keyPressEvent(QKeyEvent* event)
{
  if (event->key() == Qt::Key_Up || event->key() == Qt::Key_Down)
  {
    this->Turn(event->key() == Qt::Key_Up ? DegreesPerNotch : -DegreesPerNotch);
    return;
  }
  QWidget::keyPressEvent(event);
}

void CurvedView::Turn(double degrees)
{
  if (this->path)
  {
    const double turned =
      std::remainder(this->model->CurrentScene().slices.curveTurnDegrees + degrees, 360.0);
    this->model->Edit(ScenePart::Slices, tr("turn the cut about the curve"),
      [turned](Scene& scene) { scene.slices.curveTurnDegrees = turned; });
  }
}

}
