#ifndef Varimarch_Viewer_MeasureOverlay_h
#define Varimarch_Viewer_MeasureOverlay_h

#include "Viewer/Model/MeasureTexts.h"
#include "Viewer/View/PictureFrame.h"

#include <QRectF>

#include <functional>

class QPainter;
class vtkImageData;

namespace varimarch
{

/// A scene with its measurements and its volume.
struct MeasuredScene
{
  const Scene& scene;
  const MeasureTexts& texts;
  vtkImageData* image;
};

/// The part of the measurements that a view shows. World space [mm].
struct MeasuresShown
{
  /// Returns true if the view shows objects in the box between two corners.
  std::function<bool(const std::array<double, 3>&, const std::array<double, 3>&)> between;

  /// Returns true for points behind something opaque; lines are dashed there.
  std::function<bool(const std::array<double, 3>&)> isHidden;
};

/// Draws distances, angles and boxes over an image; their labels do not overlap.
void DrawMeasures(QPainter& painter, const MeasuredScene& measured, const PictureFrame& frame,
  const MeasuresShown& shown);

/// Draws text that is legible on any background.
void DrawLegibly(QPainter& painter, const QRectF& box, int alignment, const QString& text);

/// Draws a line that is visible on any background, with dots at its ends.
void DrawMark(
  QPainter& painter, const QPointF& from, const QPointF& to, Qt::PenStyle style = Qt::SolidLine);

}

#endif
