#ifndef Varimarch_Viewer_MeasureOverlay_h
#define Varimarch_Viewer_MeasureOverlay_h

#include "Viewer/Model/MeasureTexts.h"
#include "Viewer/View/PictureFrame.h"

#include <QRectF>

#include <functional>
#include <vector>

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
  /// Returns true if the view shows something that reaches from the first to the last of points.
  std::function<bool(const std::vector<glm::dvec3>&)> reaching;

  /// Returns true for points behind something opaque; lines are dashed there.
  std::function<bool(const std::array<double, 3>&)> isHidden;

  /// Places of other texts, which labels do not cover [logical pixels].
  std::vector<QRectF> taken = {};
};

/// Draws the visible measurements over an image. Their labels never overlap; one for which there is
/// no room is left out.
void DrawMeasures(QPainter& painter, const MeasuredScene& measured, const PictureFrame& frame,
  const MeasuresShown& shown);

/// Draws text that is legible on any background. Returns the place that it takes.
QRectF DrawLegibly(QPainter& painter, const QRectF& box, int alignment, const QString& text);

/// Draws a dot that can be dragged.
void DrawDot(QPainter& painter, const QPointF& place);

/// Draws a line that is visible on any background, with dots at its ends.
void DrawMark(QPainter& painter, const QPointF& from, const QPointF& to);

}

#endif
