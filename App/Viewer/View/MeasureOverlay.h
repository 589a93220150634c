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

/// A scene, what was measured in it, and its volume.
struct MeasuredScene
{
  const Scene& scene;
  const MeasureTexts& texts;
  vtkImageData* image;
};

/// Whether something between two corners of a box along the patient's axes is shown, [mm].
using ShownBetween =
  std::function<bool(const std::array<double, 3>&, const std::array<double, 3>&)>;

/// Distances, angles and boxes over a picture.
void DrawMeasures(QPainter& painter, const MeasuredScene& measured, const PictureFrame& frame,
  const ShownBetween& isShown);

/// Text that is legible on whatever is below it.
void DrawLegibly(QPainter& painter, const QRectF& box, int alignment, const QString& text);

/// A line that is visible on whatever is below it, with dots at its ends.
void DrawMark(QPainter& painter, const QPointF& from, const QPointF& to);

}

#endif
