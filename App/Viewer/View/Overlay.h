#ifndef Varimarch_Viewer_Overlay_h
#define Varimarch_Viewer_Overlay_h

#include "Viewer/View/MeasureOverlay.h"

class QPainter;

namespace varimarch
{

/// Draws the annotations of an image, on the screen and in files: letters of the patient's
/// directions at its edges, a cube with the same letters, and the measurements.
/// @param mask   the part that the scissors keep, see Scissors.h; may be null
/// @param taken  places of other texts, which labels of measurements do not cover
void DrawOverlay(QPainter& painter, const MeasuredScene& measured, const PictureFrame& frame,
  vtkImageData* mask, std::vector<QRectF> taken = {});

}

#endif
