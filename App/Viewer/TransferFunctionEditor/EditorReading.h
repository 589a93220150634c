#ifndef Varimarch_Viewer_EditorReading_h
#define Varimarch_Viewer_EditorReading_h

#include "Viewer/TransferFunctionEditor/EditorPainter.h"

namespace varimarch
{

/// What the values under the pointer are: "HU 320, opacity 0.35, 0.12 % of voxels, 4.1 % above".
/// The first part of the voxels is that of the bar under the pointer.
QString ReadingAt(const EditorPicture& picture, const QPointF& position);

/// For those who hear the editor: "point 2 of 4, HU 320, opacity 0.35".
QString DescriptionOf(const EditorPicture& picture, const NodeId& node);

}

#endif
