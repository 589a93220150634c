// The part of MainWindow that shows the notice and the help menu.

#include "Viewer/MainWindow.h"

#include "Viewer/CommandPalette.h"
#include "Viewer/KeysDialog.h"
#include "Viewer/Model/Language.h"
#include "Viewer/Model/Log.h"

#include <QActionGroup>
#include <QCoreApplication>
#include <QDesktopServices>
#include <QFileInfo>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <QStandardPaths>
#include <QStatusBar>
#include <QUrl>

namespace varimarch
{

namespace
{

const QString NoticeKey = QStringLiteral("notice/read");

QString Notice()
{
  return MainWindow::tr(
    "<b>Not for diagnostic use.</b> This program is not a medical device. It must not be used to "
    "diagnose, to plan or to guide a treatment.");
}

}

void MainWindow::ShowNoticeOnce()
{
  if (QSettings().value(NoticeKey).toBool())
  {
    return;
  }
  auto* const box = new QMessageBox(
    QMessageBox::Information, tr("Varimarch"), Notice(), QMessageBox::NoButton, this);
  box->setObjectName("notice");
  box->setAttribute(Qt::WA_DeleteOnClose);
  QPushButton* const understood = box->addButton(tr("I understand"), QMessageBox::AcceptRole);
  connect(
    understood, &QAbstractButton::clicked, box, [] { QSettings().setValue(NoticeKey, true); });
  box->open();
}

void MainWindow::MakeLanguageMenu(QMenu* menu)
{
  auto* const choices = new QActionGroup(this);
  QVector<Language> offered = Languages();
  offered.prepend({ {}, tr("As on the &desktop") });
  for (const Language& language : offered)
  {
    QAction* const action = choices->addAction(menu->addAction(language.name));
    action->setCheckable(true);
    action->setChecked(language.code == ChosenLanguage());
    connect(action, &QAction::triggered, this,
      [this, language]
      {
        ChooseLanguage(language.code);
        this->statusBar()->showMessage(language.code.isEmpty()
            ? tr("The program will use the desktop's language after a restart")
            : tr("The program will use %1 after a restart").arg(language.name));
      });
  }
}

void MainWindow::MakeHelpMenu()
{
  QMenu* const menu = this->menuBar()->addMenu(tr("&Help"));
  menu
    ->addAction(
      tr("&Find a command…"), this, [this] { (new CommandPalette(this->menuBar(), this))->open(); },
      QKeySequence("Ctrl+K"))
    ->setObjectName("findCommand");
  menu
    ->addAction(
      tr("&Mouse and keys"), this, [this] { ShowKeys(this->menuBar(), this); },
      QKeySequence(Qt::Key_F1))
    ->setObjectName("mouseAndKeys");
  this->MakeLanguageMenu(menu->addMenu(tr("&Language")));
  menu->addAction(tr("Open the l&og folder"), this,
    []
    {
      const QString folder = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
      QDesktopServices::openUrl(QUrl::fromLocalFile(QFileInfo(LogFileIn(folder)).path()));
    });
  menu->addAction(tr("&About Varimarch"), this, &MainWindow::ShowAbout);
}

void MainWindow::ShowAbout()
{
  QMessageBox::about(this, tr("About Varimarch"),
    tr("<b>Varimarch %1</b><p>Shows CT and MR volumes with a promised error.</p>")
        .arg(QCoreApplication::applicationVersion()) +
      "<p>" + Notice() + "</p>");
}

}
