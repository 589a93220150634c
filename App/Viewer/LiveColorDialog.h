#ifndef Varimarch_Viewer_LiveColorDialog_h
#define Varimarch_Viewer_LiveColorDialog_h

#include <QColor>

#include <functional>

class QColorDialog;
class QWidget;

namespace varimarch
{

/// Opens a dialog for a colour that shows while it is chosen. It deletes itself when it is closed;
/// to take the colour back when it is rejected is the caller's.
/// @param changed  is called with every colour on the way
QColorDialog* OpenLiveColorDialog(
  const QColor& color, const std::function<void(const QColor&)>& changed, QWidget* parent);

}

#endif
