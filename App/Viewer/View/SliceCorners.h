#ifndef Varimarch_Viewer_SliceCorners_h
#define Varimarch_Viewer_SliceCorners_h

#include "Scene/Slices/SlicePicture.h"

#include <QRectF>

#include <set>
#include <vector>

class QPainter;
class vtkImageData;

namespace varimarch
{

/// A text over a slice that the user can hide.
enum class CornerText
{
  Window,     ///< window, level and zoom, in the upper left
  Number,     ///< number of the slice, in the upper right
  Position,   ///< below it
  Slab,       ///< its thickness, below that
  Scale,      ///< a bar of a round length, in the lower right
  Directions, ///< letters of the patient's directions at the edges
};

using CornerTexts = std::set<CornerText>;

inline CornerTexts AllCornerTexts()
{
  return { CornerText::Window, CornerText::Number, CornerText::Position, CornerText::Slab,
    CornerText::Scale, CornerText::Directions };
}

/// A slice with its texts.
struct SliceCorners
{
  const SliceRequest& request; ///< the slice, which fills the view
  double zoom;                 ///< 1: the volume just fits into the view
  const CornerTexts& texts;    ///< that are shown
};

/// Draws texts over a slice. Returns the places that they take.
std::vector<QRectF> DrawSliceCorners(
  QPainter& painter, const QRectF& view, vtkImageData* image, const SliceCorners& corners);

/// The length of a scale bar [mm]: 1, 2 or 5 times a power of ten, and the largest within a limit.
double ScaleBarMm(double mostMm);

}

#endif
