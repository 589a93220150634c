#ifndef Varimarch_Viewer_Overlay_h
#define Varimarch_Viewer_Overlay_h

#include "Viewer/Model/MeasureTexts.h"
#include "Viewer/View/PictureFrame.h"

#include <QPointF>
#include <QRectF>
#include <QString>

#include <functional>
#include <optional>
#include <vector>

class QPainter;
class QWidget;
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

/// Draws the annotations of an image, on the screen and in files: letters of the patient's
/// directions at its edges, a cube with the same letters, and the measurements.
/// @param mask   the part that the scissors keep, see SceneCuts.h; may be null
/// @param taken  places of other texts, which labels of measurements do not cover
void DrawOverlay(QPainter& painter, const MeasuredScene& measured, const PictureFrame& frame,
  vtkImageData* mask, std::vector<QRectF> taken = {});

/// Shows a line to type words into, over a view. Return, or a click elsewhere, takes them; Esc
/// takes no words. The view owns the line.
void AskForWordsOver(
  QWidget* view, const QPointF& place, const std::function<void(const QString&)>& take);

/// Places of labels in an image, none of which overlaps another.
class LabelPlaces
{
public:
  /// @param newTaken  places of other texts
  explicit LabelPlaces(const QSizeF& image, const std::vector<QRectF>& newTaken = {});

  /// Takes the free place for a label that is nearest to a wanted one. Empty if none is free.
  std::optional<QRectF> Take(const QRectF& wanted);

private:
  bool IsFree(const QRectF& place) const;
  /// The upper left corner of the nearest free place; empty if none is free.
  std::optional<QPointF> NearestFree(const QRectF& wanted) const;

  QRectF inside;
  std::vector<QRectF> taken;
  std::optional<QSizeF> tooLarge; ///< a size for which no place was free
};

}

#endif
