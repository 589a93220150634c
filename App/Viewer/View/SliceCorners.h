#ifndef Varimarch_Viewer_SliceCorners_h
#define Varimarch_Viewer_SliceCorners_h

#include "Scene/SlicePicture.h"

#include <QRectF>

class QPainter;
class vtkImageData;

namespace varimarch
{

/// Draws texts over a slice: window, level and zoom in the upper left, number, position and slab in
/// the upper right, a bar of a round length in the lower right, and the letters of the patient's
/// directions at the edges.
/// @param request  the slice, which fills the view
/// @param zoom     1: the volume just fits into the view
void DrawSliceCorners(QPainter& painter, const QRectF& view, vtkImageData* image,
  const SliceRequest& request, double zoom);

/// The length of a scale bar [mm]: 1, 2 or 5 times a power of ten, and the largest within a limit.
double ScaleBarMm(double mostMm);

}

#endif
