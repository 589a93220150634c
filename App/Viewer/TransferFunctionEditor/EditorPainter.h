#ifndef Varimarch_Viewer_EditorPainter_h
#define Varimarch_Viewer_EditorPainter_h

#include "Scene/ImageStatistics.h"
#include "Viewer/TransferFunctionEditor/EditorLayout.h"

#include <QPalette>
#include <QString>

#include <memory>
#include <optional>

class QPainter;

namespace varimarch
{

/// Least width of a bar of the histogram [pixels].
constexpr double BarPixels = 2.0;

/// What the transfer-function editor shows.
struct EditorPicture
{
  EditorLayout layout;
  Look look;
  std::shared_ptr<const ImageStatistics> statistics; ///< may be none
  QString unit;
  bool logarithmicCounts = true;
  NodeSet selected;
  std::optional<NodeId> focused;  ///< by the keyboard
  std::optional<QPointF> pointer; ///< where the values under it are read
  QString reading;                ///< of them
  QRectF rubberBand;              ///< null: there is none
};

/// Paints it in the colours of a palette, dark or light.
class EditorPainter
{
public:
  EditorPainter(QPainter* painter, const EditorPicture& picture, const QPalette& palette);

  void Paint();

private:
  void PaintHistogram();
  void PaintGrid();
  void PaintTicks();
  void PaintColors();
  void PaintCurve();
  void PaintTies();
  void PaintNodes();
  void PaintPoint(const NodeId& node);
  void PaintStop(const NodeId& node);
  void PaintReading();

  QColor Ink(double strength) const;
  QPen OutlineOf(const NodeId& node) const;

  QPainter* painter;
  const EditorPicture& picture;
  const EditorLayout& layout;
  const QPalette& palette;
  TransferFunction function;
};

QColor QColorOf(const glm::dvec3& rgb);

}

#endif
