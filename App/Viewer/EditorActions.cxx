#include "Viewer/EditorActions.h"

#include <QAction>
#include <QKeyEvent>
#include <QWidget>

namespace varimarch
{

bool IsArrowKey(int key)
{
  return key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Up || key == Qt::Key_Down;
}

QAction* AddKeyAction(QWidget* editor, const QString& text, const QKeySequence& key)
{
  auto* const action = new QAction(text, editor);
  action->setShortcut(key);
  action->setShortcutContext(Qt::WidgetShortcut);
  editor->addAction(action);
  return action;
}

QAction* ActionOfKey(const QWidget& editor, const QKeyEvent& event)
{
  const int modifiers = int(event.modifiers() & ~Qt::KeypadModifier);
  const QKeySequence keys(event.key() == Qt::Key_Enter ? int(Qt::Key_Return)
      : event.key() == Qt::Key_Backspace               ? int(Qt::Key_Delete)
                                                       : event.key() | modifiers);
  for (QAction* const action : editor.actions())
  {
    if (!action->isSeparator() && action->shortcut() == keys)
    {
      return action;
    }
  }
  return nullptr;
}

}
