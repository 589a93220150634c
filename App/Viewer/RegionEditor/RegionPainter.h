#ifndef Varimarch_Viewer_RegionPainter_h
#define Varimarch_Viewer_RegionPainter_h

#include "Scene/Looks/ValueGradientHistogram.h"
#include "Scene/Model/Scene.h"
#include "Viewer/TransferFunctionEditor/EditorLayout.h"

#include <QImage>
#include <QPalette>
#include <QPointF>
#include <QRectF>
#include <QString>

#include <memory>
#include <optional>
#include <vector>

class QPainter;

namespace varimarch
{

// Edits of regions of value and gradient magnitude, independent of widgets.

/// The part of the plane that regions stay in.
struct RegionPlane
{
  std::array<double, 2> values = { 0.0, 1.0 };
  double largestGradient = 1.0;

  /// The smallest sides of a region.
  double LeastValueWidth() const { return 0.002 * (this->values[1] - this->values[0]); }
  double LeastGradientWidth() const { return 0.002 * this->largestGradient; }
};

/// A side or corner of a region: -1 is the smaller end, 1 the larger one, and 0 the middle. Both 0
/// mean the region itself.
struct RegionHandle
{
  int value = 0;
  int gradient = 0;
};

/// Moves a handle of a region, or the region, as far as the plane allows. A side that is pushed
/// against the other one stops.
LookRegion DragRegion(const LookRegion& region, RegionHandle handle, double valueShift,
  double gradientShift, const RegionPlane& plane);

/// A region around a point, with a seventh of the visible widths to each side.
LookRegion NewRegion(RegionShape shape, double value, double gradient,
  std::array<double, 2> visibleWidths, const RegionPlane& plane);

/// Geometry of the editor in widget pixels: the readout of the pointer, the plot, and the rows of
/// the values and of the gradients beside it.
struct RegionLayout
{
  void Resize(const QSizeF& size, double lineHeight, double gradientTextWidth);

  QPointF ToPoint(double value, double gradient) const;
  double ToValue(double x) const { return this->values.ToValue(x); }
  double ToGradient(double y) const { return this->gradients.ToValue(this->plot.bottom() - y); }

  QRectF RectOf(const LookRegion& region) const;

  /// The handle of a region under the pointer, without the region itself.
  std::optional<RegionHandle> HandleAt(const LookRegion& region, const QPointF& position) const;

  /// The foremost region under the pointer. A preferred one wins.
  std::optional<int> RegionAt(
    const std::vector<LookRegion>& regions, const QPointF& position, int preferred) const;

  QRectF reading;
  QRectF plot;
  QRectF ticks;
  ValueAxis values;
  ValueAxis gradients; ///< its pixels count upwards from the lower end of the plot
};

/// The eight handles of a region, corners first.
std::vector<RegionHandle> HandlesOfRegion();

/// Centre of a handle on a rectangle.
QPointF PlaceOfHandle(const QRectF& rect, RegionHandle handle);

/// The state that the editor of regions paints.
struct RegionPicture
{
  RegionLayout layout;
  std::vector<LookRegion> regions;
  std::shared_ptr<const ValueGradientHistogram> histogram; ///< null until it is counted
  QImage counts;                                           ///< picture of the histogram
  QString unit;
  int selected = -1;     ///< -1: none
  bool hasFocus = false; ///< the keyboard acts on the selected region
  QString reading;       ///< text of the readout
};

/// A histogram as shades of a colour: the logarithms of its counts, the gradient 0 at the bottom.
QImage PictureOfCounts(const ValueGradientHistogram& histogram, const QColor& ink);

/// Paints the editor in the colours of a palette, dark or light.
void PaintRegions(QPainter& painter, const RegionPicture& picture, const QPalette& palette);

}

#endif
