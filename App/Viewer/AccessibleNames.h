#ifndef Varimarch_Viewer_AccessibleNames_h
#define Varimarch_Viewer_AccessibleNames_h

class QWidget;

namespace varimarch
{

/// Tells screen readers that widgets which draw themselves, such as slices, are canvases. Qt says
/// of them only that they fill room. Called before the first window is made.
void TellRolesOfViews();

/// Names controls for screen readers that consist of several, such as a slider with its number:
/// each part without a name gets that of the whole, or of the label beside the whole. Buttons of
/// actions obey screen readers.
void NamePartsOfControls(QWidget* window);

}

#endif
