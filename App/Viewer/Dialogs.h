#ifndef Varimarch_Viewer_Dialogs_h
#define Varimarch_Viewer_Dialogs_h

#include <QColor>
#include <QGuiApplication>
#include <QString>
#include <QStringList>

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

/// Asks under which name to save a file. A name without an extension gets that of the chosen filter
/// before the dialog looks for an existing file of that name.
/// @param filters  such as "Sessions (*.json)"; the first one is preselected
/// @param name     proposed name
/// @return empty if the user cancels
QString ChosenFileToSave(
  QWidget* parent, const QString& title, const QStringList& filters, const QString& name);

/// Shows, while it exists, that the program does not react.
class WaitCursor
{
public:
  WaitCursor() { QGuiApplication::setOverrideCursor(Qt::WaitCursor); }
  ~WaitCursor() { QGuiApplication::restoreOverrideCursor(); }
  WaitCursor(const WaitCursor&) = delete;
  WaitCursor& operator=(const WaitCursor&) = delete;
};

}

#endif
