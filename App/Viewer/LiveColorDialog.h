#ifndef Varimarch_Viewer_LiveColorDialog_h
#define Varimarch_Viewer_LiveColorDialog_h

#include <QColor>

#include <functional>

class QColorDialog;
class QWidget;

namespace varimarch
{

/// Opens a colour dialog that reports the colour while the user chooses it. The dialog deletes
/// itself when closed. If it is rejected, the caller must restore the old colour.
/// @param changed  called with every intermediate colour
QColorDialog* OpenLiveColorDialog(
  const QColor& color, const std::function<void(const QColor&)>& changed, QWidget* parent);

}

#endif
