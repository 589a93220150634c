#ifndef Varimarch_Viewer_SaveDialog_h
#define Varimarch_Viewer_SaveDialog_h

#include <QString>
#include <QStringList>

class QWidget;

namespace varimarch
{

/// Asks under which name to save a file. A name without an extension gets that of the chosen filter
/// before the dialog looks for an existing file of that name.
/// @param filters  such as "Sessions (*.json)"; the first one is preselected
/// @param name     proposed name
/// @return empty if the user cancels
QString ChosenFileToSave(
  QWidget* parent, const QString& title, const QStringList& filters, const QString& name);

}

#endif
