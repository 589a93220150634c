#include "Viewer/KeysDialog.h"

#include "Viewer/CommandPalette.h"

#include <QAction>
#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QTextBrowser>
#include <QVBoxLayout>

#include <tuple>

namespace varimarch
{

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
