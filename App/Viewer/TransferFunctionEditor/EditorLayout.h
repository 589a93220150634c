#ifndef Varimarch_Viewer_EditorLayout_h
#define Varimarch_Viewer_EditorLayout_h

#include "Viewer/TransferFunctionEditor/LookEditing.h"
#include "Viewer/TransferFunctionEditor/ValueAxis.h"

#include <QFontMetricsF>
#include <QRectF>

#include <optional>

namespace varimarch
{

/// Geometry of the transfer-function editor in widget pixels: the readout of the pointer, the
/// opacity plot, the value axis, and the colour bar with its stops.
struct EditorLayout
{
  void Resize(const QSizeF& size, const QFontMetricsF& font);

  double ToY(double opacity) const;

  /// [0, 1], also for positions outside the plot.
  double ToOpacity(double y) const;

  /// Centre of a node: a point of the curve, an isosurface, or a stop below the colour bar.
  QPointF PositionOf(const Look& look, const NodeId& node) const;

  /// The node nearest to the pointer within reach. At equal distance, a preferred node wins.
  std::optional<NodeId> NodeAt(
    const Look& look, const QPointF& position, const NodeSet& preferred) const;

  /// True if the pointer is on the curve between its nodes. Isosurfaces have no curve.
  bool IsOnCurve(const Look& look, const QPointF& position) const;

  /// Longest ramp from a new point to the dark point added with it [units of the data].
  double LongestRamp() const { return 0.05 * (this->axis.Last() - this->axis.First()); }

  QRectF reading;
  QRectF plot;
  QRectF colorBar;
  QRectF stops;
  QRectF ticks;
  ValueAxis axis;
  bool hasColors = true;             ///< false: there is no colour bar
  bool lowOpacitiesEnlarged = false; ///< true: the height is the square root of the opacity
};

}

#endif
