#ifndef Varimarch_Viewer_CurrentContext_h
#define Varimarch_Viewer_CurrentContext_h

namespace varimarch
{

/// While it lives, the thread may draw without a display. A thread has one current context: this
/// lets go of Qt's, and in the end of EGL's, without which Qt's windows could not draw again.
class DrawingWithoutDisplay
{
public:
  DrawingWithoutDisplay();
  ~DrawingWithoutDisplay();
  DrawingWithoutDisplay(const DrawingWithoutDisplay&) = delete;
  DrawingWithoutDisplay& operator=(const DrawingWithoutDisplay&) = delete;
};

}

#endif
