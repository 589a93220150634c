// The part of MainWindow that shows the notice and the help menu.

#include "Viewer/MainWindow.h"

#include "Viewer/CommandPalette.h"
#include "Viewer/KeysDialog.h"
#include "Viewer/Model/Language.h"
#include "Viewer/Model/Log.h"
#include "Viewer/Open/StartPage.h"
#include "Viewer/Tour.h"
#include "Viewer/View/ComparisonView.h"
#include "Viewer/View/SliceView.h"

#include <QActionGroup>
#include <QCoreApplication>
#include <QDesktopServices>
#include <QDockWidget>
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

std::function<QWidget*()> Place(QWidget* widget)
{
  return [widget] { return widget; };
}

// A panel, in front of those that share its place.
std::function<QWidget*()> Panel(MainWindow* window, const char* name)
{
  return [window, name]() -> QWidget*
  {
    auto* const dock = window->findChild<QDockWidget*>(name);
    dock->show();
    dock->raise();
    return dock;
  };
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
  menu->addAction(tr("&Two-minute tour"), this, &MainWindow::ShowTour)->setObjectName("showTour");
  this->MakeLanguageMenu(menu->addMenu(tr("&Language")));
  menu->addAction(tr("Open the l&og folder"), this,
    []
    {
      const QString folder = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
      QDesktopServices::openUrl(QUrl::fromLocalFile(QFileInfo(LogFileIn(folder)).path()));
    });
  menu->addAction(tr("&About Varimarch"), this, &MainWindow::ShowAbout);
}

// The tour shows the phantom if there is no scan, and none is being loaded.
void MainWindow::ShowTour()
{
  if (!this->model.CurrentStudy() && !this->loader.IsLoading())
  {
    this->OpenSample(SampleTorso());
  }
  if (auto* const shown = this->findChild<Tour*>())
  {
    shown->close();
  }
  (new Tour(this->TourSteps(), this))->show();
}

std::vector<TourStep> MainWindow::TourSteps()
{
  return {
    { tr("The volume"),
      tr("Drag to turn it, drag with Shift or the middle button to move it, and turn the wheel to "
         "come nearer. A double-click shows it alone, another one all views again."),
      Place(this->view) },
    { tr("Slices"),
      tr("The wheel goes through the slices. Drag the cross to move all three, its arms to tilt "
         "them, and drag with the right button for brightness and contrast. Number keys choose a "
         "usual window."),
      Place(this->sliceViews.front()) },
    { tr("Looks"),
      tr("Each image is this scan with another look. Click one; Ctrl+Z takes it back, as it does "
         "every edit."),
      Panel(this, "presets") },
    { tr("Transfer function"),
      tr("The curve says how opaque each value is, over the histogram of the scan. Drag its "
         "points, click to add one, and double-click a point for its numbers."),
      Panel(this, "look") },
    { tr("Cut away"),
      tr("Remove the table with one click, drag a box or a plane in the volume, or cut with the "
         "scissors of the tool bar."),
      Panel(this, "cuts") },
    { tr("Measurements"),
      tr("Choose a measurement in the tool bar and drag in a slice or in the volume. All of them "
         "are listed here and in reports."),
      Panel(this, "measures") },
    { tr("Everything else"),
      tr("Ctrl+K finds any command by a word, and F1 lists what the mouse and the keys do. The "
         "menu File saves sessions, images and reports."),
      Place(this->menuBar()) },
  };
}

void MainWindow::ShowAbout()
{
  QMessageBox::about(this, tr("About Varimarch"),
    tr("<b>Varimarch %1</b><p>Shows CT and MR volumes with a promised error.</p>")
        .arg(QCoreApplication::applicationVersion()) +
      "<p>" + Notice() + "</p>");
}

}
