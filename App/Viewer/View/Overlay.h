#ifndef Varimarch_Viewer_Overlay_h
#define Varimarch_Viewer_Overlay_h

#include "Viewer/View/MeasureOverlay.h"

class QPainter;

namespace varimarch
{

/// What is written over a picture of a scene, on the screen and in files alike: the letters of the
/// patient's directions at its edges, a cube with the same letters, and what was measured.
void DrawOverlay(QPainter& painter, const MeasuredScene& measured, const PictureFrame& frame);

}

#endif
