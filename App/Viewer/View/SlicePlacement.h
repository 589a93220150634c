#ifndef Varimarch_Viewer_SlicePlacement_h
#define Varimarch_Viewer_SlicePlacement_h

#include "Scene/Slices/SliceAxes.h"
#include "Scene/Slices/SlicePicture.h"

#include <QPointF>
#include <QSize>

#include <array>

class vtkImageData;

namespace varimarch
{

/// How the user has placed a slice in its view.
struct SliceZoom
{
  double factor = 1.0; ///< 1: the volume just fits into the view
  QPointF shiftMm = { 0,
    0 }; ///< offset of the view's centre from the volume's, to the right and down
};

/// Which point of the patient is at which place of a view that shows a slice.
class SlicePlacement
{
public:
  /// @param pointMm  a point of the slice, such as the crosshair; world space
  SlicePlacement(vtkImageData* image, const SliceAxes& axes, const std::array<double, 3>& pointMm,
    const QSize& view, const SliceZoom& zoom);

  double MmPerPixel() const { return this->mmPerPixel; }

  /// The point at the view's centre.
  const std::array<double, 3>& MiddleMm() const { return this->middleMm; }

  std::array<double, 3> PointAt(const QPointF& place) const;
  QPointF PlaceOf(const std::array<double, 3>& pointMm) const;

  /// A direction in the view, to the right and down; its length is that of its part in the slice.
  QPointF AlongView(const std::array<double, 3>& direction) const;

private:
  SliceAxes axes;
  QPointF centre; ///< the view's middle [pixels]
  double mmPerPixel;
  std::array<double, 3> middleMm;
};

/// The lines in which the other two planes cut a slice. They cross in the crosshair, and their
/// outer parts turn those planes about it.
class CrosshairArms
{
public:
  /// @param view  size of the view of the slice [pixels]
  CrosshairArms(SlicePlane plane, const SliceTurn& turn, const SlicePlacement& placement,
    const std::array<double, 3>& crosshairMm, const QSize& view);

  /// The place of the crosshair in the view.
  const QPointF& Middle() const { return this->middle; }

  /// The directions of both lines in the view, of unit length.
  const std::array<QPointF, 2>& Directions() const { return this->directions; }

  /// True on the outer part of an arm.
  bool Hold(const QPointF& place) const;

  /// The turn of the planes after an arm is dragged from one place to another.
  SliceTurn Dragged(const QPointF& from, const QPointF& to) const;

private:
  SliceTurn turn;
  std::array<double, 3> axis; ///< about which an angle from the right downwards is counted
  QPointF middle;
  std::array<QPointF, 2> directions;
  double innerPixels; ///< nearer to the crosshair, the arms cannot be dragged
};

}

#endif
