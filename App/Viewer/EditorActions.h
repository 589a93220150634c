#ifndef Varimarch_Viewer_EditorActions_h
#define Varimarch_Viewer_EditorActions_h

#include <QKeySequence>
#include <QString>

class QAction;
class QKeyEvent;
class QWidget;

namespace varimarch
{

// Keys of the editors of transfer functions: each command is an action of the editor, so that
// menus, buttons and keys share it.

/// Factor by which one key zooms.
constexpr double ZoomPerKey = 1.25;

bool IsArrowKey(int key);

/// Adds a command that a key starts while the editor has the focus.
QAction* AddKeyAction(QWidget* editor, const QString& text, const QKeySequence& key);

/// The command of a key; null if it has none. Enter counts as Return, and Backspace as Delete.
QAction* ActionOfKey(const QWidget& editor, const QKeyEvent& event);

}

#endif
