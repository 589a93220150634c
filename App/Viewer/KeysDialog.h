#ifndef Varimarch_Viewer_KeysDialog_h
#define Varimarch_Viewer_KeysDialog_h

class QMenuBar;
class QWidget;

namespace varimarch
{

/// Opens a table of what the mouse does in each view, and of all keys of the menus.
void ShowKeys(QMenuBar* menuBar, QWidget* parent);

}

#endif
