#ifndef Varimarch_Viewer_EditorPainter_h
#define Varimarch_Viewer_EditorPainter_h

#include "Scene/Volumes/ImageStatistics.h"
#include "Viewer/TransferFunctionEditor/EditorLayout.h"

#include <QPalette>
#include <QString>

#include <memory>
#include <optional>

class QPainter;

namespace varimarch
{

/// Smallest width of a histogram bar [pixels].
constexpr double BarPixels = 2.0;

/// The state that the transfer-function editor paints.
struct EditorPicture
{
  EditorLayout layout;
  Look look;
  std::shared_ptr<const ImageStatistics> statistics; ///< may be null
  QString unit;
  bool logarithmicCounts = true;
  NodeSet selected;
  std::optional<NodeId> focused;  ///< node with the keyboard focus
  std::optional<QPointF> pointer; ///< position of the readout
  QString reading;                ///< text of the readout
  QRectF rubberBand;              ///< null rectangle: none
};

/// Paints the editor in the colours of a palette, dark or light.
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

/// Readout at the pointer: "HU 320, opacity 0.35, 0.12 % of voxels, 4.1 % above". The first
/// percentage is that of the histogram bar under the pointer.
QString ReadingAt(const EditorPicture& picture, const QPointF& position);

/// Description of a node for screen readers: "point 2 of 4, HU 320, opacity 0.35".
QString DescriptionOf(const EditorPicture& picture, const NodeId& node);

}

#endif
