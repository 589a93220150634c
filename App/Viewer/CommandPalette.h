#ifndef Varimarch_Viewer_CommandPalette_h
#define Varimarch_Viewer_CommandPalette_h

#include <QDialog>
#include <QVector>

class QAction;
class QLineEdit;
class QListWidget;
class QMenuBar;
class QWidget;

namespace varimarch
{

/// A command of the menus, with the menus that lead to it: "View: Panels: Look".
struct Command
{
  QString path;
  QAction* action;
};

/// All commands of a menu bar and its submenus, apart from those that are not available now.
QVector<Command> CommandsOf(QMenuBar* menuBar);

/// Finds a command of the menus by a few letters of its words, and starts it.
class CommandPalette : public QDialog
{
  Q_OBJECT

public:
  CommandPalette(QMenuBar* menuBar, QWidget* parent);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void Filter(const QString& text);
  void Start();

  QVector<Command> commands;
  QLineEdit* search;
  QListWidget* list;
};

/// Opens a table of what the mouse does in each view, and of all keys of the menus.
void ShowKeys(QMenuBar* menuBar, QWidget* parent);

}

#endif
