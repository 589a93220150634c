// The part of SliceView that draws.

#include "Viewer/View/SliceView.h"

#include "Scene/Placing.h"
#include "Scene/SceneVolumes.h"
#include "Scene/SliceFusing.h"
#include "Scene/SliceSegments.h"
#include "Viewer/View/MeasureOverlay.h"
#include "Viewer/View/SliceCorners.h"

#include <QColor>
#include <QImage>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace varimarch
{

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

}
