#ifndef Varimarch_Viewer_Gesture_h
#define Varimarch_Viewer_Gesture_h

namespace varimarch
{

/// Returns a new gesture number, > 0. All edits of one drag, or of one visit to a popover, share a
/// number, which makes them a single undo step.
int NewGesture();

}

#endif
