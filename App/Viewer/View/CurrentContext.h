#ifndef Varimarch_Viewer_CurrentContext_h
#define Varimarch_Viewer_CurrentContext_h

namespace varimarch
{

/// Lets the thread render without a display during its lifetime. A thread has only one current
/// context: the constructor releases Qt's, and the destructor releases EGL's, because Qt's windows
/// could not draw otherwise.
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
