#ifndef Varimarch_Viewer_EditorLayout_h
#define Varimarch_Viewer_EditorLayout_h

#include "Scene/Volumes/ImageStatistics.h"
#include "Viewer/TransferFunctionEditor/LookEditing.h"

#include <QFontMetricsF>
#include <QRectF>

#include <cstdint>
#include <optional>
#include <vector>

namespace varimarch
{

/// Maps values of the data to a horizontal range of pixels. It can be zoomed and panned, but never
/// so far that the data leaves the range.
class ValueAxis
{
public:
  /// Sets the range of the data. The visible range is limited to between 1/10000 and four times it.
  void SetData(double smallest, double largest);
  void SetPixels(double left, double right);

  /// Shows the given range with a small margin on both sides.
  void Fit(double first, double last);

  /// @param factor  > 1 zooms in; the value under the pixel stays in place
  void Zoom(double pixel, double factor);

  /// Moves the values with the pointer.
  void Pan(double pixels);

  double First() const { return this->first; }
  double Last() const { return this->last; }

  double ToPixel(double value) const;
  double ToValue(double pixel) const;
  double ValuePerPixel() const;

  /// Rounds a value to a power of ten that is at most `pixels` wide, as suits a position of the
  /// pointer.
  double Rounded(double value, double pixels) const;

  /// Number of decimals that distinguish neighbouring pixels.
  int Decimals() const;

  /// Round numbers that are at least `pixelsApart` apart.
  std::vector<double> Ticks(double pixelsApart) const;

private:
  void Show(double newFirst, double newLast);

  double smallest = 0.0;
  double largest = 1.0;
  double first = 0.0;
  double last = 1.0;
  double left = 0.0;
  double right = 1.0;
};

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

/// A histogram with bars of equal width. Each bar covers whole bins, so that bars neither flicker
/// when the axis moves nor are empty because they are narrower than the spacing of the values.
class HistogramBars
{
public:
  struct Bar
  {
    double first;
    double last;
    std::int64_t count;
  };

  /// @param leastWidth  of a bar [units of the data]. The statistics must outlive this object.
  HistogramBars(const ImageStatistics& statistics, double leastWidth);

  /// Bars that overlap the range, in order.
  std::vector<Bar> Between(double first, double last) const;

  /// The bar at a value; empty outside the data.
  Bar At(double value) const;

private:
  Bar BarOfIndex(std::int64_t index) const;
  std::int64_t IndexOf(double value) const;

  const ImageStatistics* statistics;
  std::int64_t binsPerBar;
};

}

#endif
