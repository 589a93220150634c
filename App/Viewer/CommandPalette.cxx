#include "Viewer/CommandPalette.h"

#include <QAction>
#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QTextBrowser>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>
#include <tuple>

namespace varimarch
{

namespace
{

// The text of a menu has its key behind '&', and dots if a dialog follows.
QString WordsOf(QString text)
{
  return text.remove('&').remove(QChar(0x2026)).simplified();
}

void AddCommands(const QList<QAction*>& actions, const QString& path, QVector<Command>& commands)
{
  for (QAction* const action : actions)
  {
    if (action->isSeparator() || !action->isEnabled() || !action->isVisible())
    {
      continue;
    }
    const QString own =
      path.isEmpty() ? WordsOf(action->text()) : path + ": " + WordsOf(action->text());
    if (QMenu* const menu = action->menu())
    {
      emit menu->aboutToShow(); // some menus are filled when they are shown
      AddCommands(menu->actions(), own, commands);
    }
    else
    {
      commands.append({ own, action });
    }
  }
}

bool HoldsAll(const QString& text, const QStringList& words)
{
  return std::all_of(words.begin(), words.end(),
    [&](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
}

}

QVector<Command> CommandsOf(QMenuBar* menuBar)
{
  QVector<Command> commands;
  AddCommands(menuBar->actions(), {}, commands);
  return commands;
}

CommandPalette::CommandPalette(QMenuBar* menuBar, QWidget* parent)
  : QDialog(parent)
  , commands(CommandsOf(menuBar))
  , search(new QLineEdit)
  , list(new QListWidget)
{
  this->setObjectName("commandPalette");
  this->setWindowTitle(tr("Find a command"));
  this->setAttribute(Qt::WA_DeleteOnClose);
  this->resize(460, 360);
  this->search->setPlaceholderText(tr("Some letters of the command, such as \"panel look\""));
  this->search->setAccessibleName(tr("Command"));
  this->search->installEventFilter(this);
  this->list->setAccessibleName(tr("Commands"));
  this->list->setFocusPolicy(Qt::NoFocus); // the arrow keys move through it from the line
  auto* const column = new QVBoxLayout(this);
  column->addWidget(this->search);
  column->addWidget(this->list);
  connect(this->search, &QLineEdit::textChanged, this, &CommandPalette::Filter);
  connect(this->search, &QLineEdit::returnPressed, this, &CommandPalette::Start);
  connect(this->list, &QListWidget::itemClicked, this, &CommandPalette::Start);
  this->Filter({});
}

void CommandPalette::Filter(const QString& text)
{
  const QStringList words = text.split(QRegularExpression("\\s+"), Qt::SkipEmptyParts);
  this->list->clear();
  for (int i = 0; i < this->commands.size(); ++i)
  {
    const Command& command = this->commands[i];
    if (HoldsAll(command.path, words))
    {
      const QString key = command.action->shortcut().toString(QKeySequence::NativeText);
      auto* const item = new QListWidgetItem(
        key.isEmpty() ? command.path : tr("%1 (%2)").arg(command.path, key), this->list);
      item->setData(Qt::UserRole, i);
    }
  }
  this->list->setCurrentRow(0);
}

// The command starts when the dialog is closed, since it may open one of its own.
void CommandPalette::Start()
{
  if (const QListWidgetItem* const item = this->list->currentItem())
  {
    QAction* const action = this->commands[item->data(Qt::UserRole).toInt()].action;
    this->accept();
    QTimer::singleShot(0, action, &QAction::trigger);
  }
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event)
{
  if (event->type() == QEvent::KeyPress)
  {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Up || key == Qt::Key_Down || key == Qt::Key_PageUp ||
      key == Qt::Key_PageDown)
    {
      QCoreApplication::sendEvent(this->list, event);
      return true;
    }
  }
  return QDialog::eventFilter(watched, event);
}

namespace
{

struct KeyTexts
{
  Q_DECLARE_TR_FUNCTIONS(KeysDialog)
};

QString Row(const QString& key, const QString& action)
{
  return QStringLiteral("<tr><td><b>%1</b>&nbsp;&nbsp;</td><td>%2</td></tr>")
    .arg(key.toHtmlEscaped(), action.toHtmlEscaped());
}

QString Table(const QString& title, const QString& rows)
{
  return QStringLiteral("<h3>%1</h3><table>%2</table>").arg(title.toHtmlEscaped(), rows);
}

QString VolumeTable()
{
  return Table(KeyTexts::tr("Volume"),
    Row(KeyTexts::tr("Drag"), KeyTexts::tr("the chosen tool; at first it rotates")) +
      Row(KeyTexts::tr("Drag with Ctrl"), KeyTexts::tr("window and level")) +
      Row(KeyTexts::tr("Middle button"), KeyTexts::tr("move the volume")) +
      Row(KeyTexts::tr("Wheel, right button"), KeyTexts::tr("zoom")) +
      Row(KeyTexts::tr("Double-click"), KeyTexts::tr("see this view alone, or all again")) +
      Row("W A S D E Q", KeyTexts::tr("walk, with the tool Walk; arrow and page keys too")) +
      Row("Esc", KeyTexts::tr("revert a gesture that is not finished")));
}

QString SliceTable()
{
  return Table(KeyTexts::tr("Slices"),
    Row(KeyTexts::tr("Drag"), KeyTexts::tr("move the crosshair, or the chosen measurement")) +
      Row(KeyTexts::tr("Drag a line of the crosshair"), KeyTexts::tr("turn the other slices")) +
      Row(KeyTexts::tr("Right button"), KeyTexts::tr("window and level")) +
      Row(KeyTexts::tr("Middle button"), KeyTexts::tr("move the slice")) +
      Row(KeyTexts::tr("Wheel, arrow and page keys"), KeyTexts::tr("the next slices")) +
      Row(KeyTexts::tr("Ctrl with wheel, + and -"),
        KeyTexts::tr("zoom; Home shows the whole slice")) +
      Row("0 – 9", KeyTexts::tr("a usual window for CT; 0 is that of the file")) +
      Row(KeyTexts::tr("Double-click"), KeyTexts::tr("see this view alone, or all again")));
}

QString EditorTable()
{
  return Table(KeyTexts::tr("Curve of the look"),
    Row(KeyTexts::tr("Drag a point"), KeyTexts::tr("change its value and opacity")) +
      Row(KeyTexts::tr("Click the curve"), KeyTexts::tr("add a point")) +
      Row(KeyTexts::tr("Double-click a point"), KeyTexts::tr("type its numbers")) +
      Row("C", KeyTexts::tr("choose its colour")));
}

QString MenuTable(QMenuBar* menuBar)
{
  QString rows;
  for (const Command& command : CommandsOf(menuBar))
  {
    if (!command.action->shortcut().isEmpty())
    {
      rows += Row(command.action->shortcut().toString(QKeySequence::NativeText), command.path);
    }
  }
  return Table(KeyTexts::tr("Menus"), rows);
}

}

void ShowKeys(QMenuBar* menuBar, QWidget* parent)
{
  auto* const dialog = new QDialog(parent);
  dialog->setObjectName("keys");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(KeyTexts::tr("Mouse and keys"));
  dialog->resize(560, 620);
  auto* const text = new QTextBrowser;
  text->setAccessibleName(dialog->windowTitle());
  text->setHtml(VolumeTable() + SliceTable() + EditorTable() + MenuTable(menuBar));
  auto* const buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
  auto* const column = new QVBoxLayout(dialog);
  column->addWidget(text);
  column->addWidget(buttons);
  dialog->open();
}

}
