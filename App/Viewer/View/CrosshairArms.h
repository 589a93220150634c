#ifndef Varimarch_Viewer_CrosshairArms_h
#define Varimarch_Viewer_CrosshairArms_h

#include "Scene/SliceAxes.h"
#include "Viewer/View/SlicePlacement.h"

#include <QPointF>
#include <QSize>

#include <array>

namespace varimarch
{

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
