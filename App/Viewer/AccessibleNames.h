#ifndef Varimarch_Viewer_AccessibleNames_h
#define Varimarch_Viewer_AccessibleNames_h

class QWidget;

namespace varimarch
{

/// Names controls for screen readers that consist of several, such as a slider with its number:
/// each part without a name gets that of the whole, or of the label beside the whole.
void NamePartsOfControls(QWidget* window);

}

#endif
