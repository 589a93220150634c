#ifndef Varimarch_Viewer_Gesture_h
#define Varimarch_Viewer_Gesture_h

namespace varimarch
{

/// A number that no gesture had before, > 0. All changes of one drag, or of one visit to a popover,
/// carry the same, and so are one step of the history.
int NewGesture();

}

#endif
