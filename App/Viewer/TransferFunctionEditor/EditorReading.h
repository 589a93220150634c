#ifndef Varimarch_Viewer_EditorReading_h
#define Varimarch_Viewer_EditorReading_h

#include "Viewer/TransferFunctionEditor/EditorPainter.h"

namespace varimarch
{

/// Readout at the pointer: "HU 320, opacity 0.35, 0.12 % of voxels, 4.1 % above". The first
/// percentage is that of the histogram bar under the pointer.
QString ReadingAt(const EditorPicture& picture, const QPointF& position);

/// Description of a node for screen readers: "point 2 of 4, HU 320, opacity 0.35".
QString DescriptionOf(const EditorPicture& picture, const NodeId& node);

}

#endif
