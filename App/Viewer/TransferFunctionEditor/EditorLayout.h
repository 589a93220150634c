#ifndef Varimarch_Viewer_EditorLayout_h
#define Varimarch_Viewer_EditorLayout_h

#include "Viewer/TransferFunctionEditor/LookEditing.h"
#include "Viewer/TransferFunctionEditor/ValueAxis.h"

#include <QFontMetricsF>
#include <QRectF>

#include <optional>

namespace varimarch
{

/// Where everything of the transfer-function editor lies, in pixels of the widget: the values
/// under the pointer, the plot of the opacities, the axis of the values, and the bar of the colours
/// with its stops.
struct EditorLayout
{
  void Resize(const QSizeF& size, const QFontMetricsF& font);

  double ToY(double opacity) const;

  /// [0, 1], also beyond the plot.
  double ToOpacity(double y) const;

  /// The middle of a point of the curve or of a surface, or of a stop below the colour bar.
  QPointF PositionOf(const Look& look, const NodeId& node) const;

  /// The node that a pointer here means: the nearest within reach, of equals the preferred one.
  std::optional<NodeId> NodeAt(
    const Look& look, const QPointF& position, const NodeSet& preferred) const;

  /// Whether a pointer here means the curve between its nodes; there is none of isosurfaces.
  bool IsOnCurve(const Look& look, const QPointF& position) const;

  /// From a new point to a dark one that it comes with, at most [units of the data].
  double LongestRamp() const { return 0.05 * (this->axis.Last() - this->axis.First()); }

  QRectF reading;
  QRectF plot;
  QRectF colorBar;
  QRectF stops;
  QRectF ticks;
  ValueAxis axis;
  bool hasColors = true;             ///< else there is no bar
  bool lowOpacitiesEnlarged = false; ///< the height is the root of the opacity
};

}

#endif
