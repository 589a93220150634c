// The part of MainWindow that keeps the user's work: sessions, questions before it is lost, and
// what follows a reset of the graphics card.

#include "Viewer/MainWindow.h"

#include "Readers/PrivateFolder.h"
#include "Scene/SceneVolumes.h"
#include "Viewer/Model/Log.h"
#include "Viewer/SaveDialog.h"

#include <QCloseEvent>
#include <QGuiApplication>
#include <QMessageBox>
#include <QSettings>
#include <QStatusBar>
#include <QTimer>

#include <exception>

namespace varimarch
{

QString MainWindow::CurrentWork() const
{
  const auto study = this->model.CurrentStudy();
  if (!study)
  {
    return {};
  }
  const bool hasUnsaved = this->model.VolumeWithUnsavedLabels().has_value();
  return WorkText(this->model.CurrentScene(), *study) +
    (hasUnsaved ? QStringLiteral("voxels") : QString());
}

void MainWindow::ForgetAutosavedFile(Scene& scene) const
{
  for (int volume = 0; volume < VolumeCount(scene); ++volume)
  {
    auto& labels = SceneLabelsOf(scene, volume);
    if (labels && this->autosave.IsSegmentsPath(labels->path))
    {
      labels->path.clear();
    }
  }
}

bool MainWindow::MayLeaveScan()
{
  if (this->CurrentWork() == this->savedWork)
  {
    return true;
  }
  const QMessageBox::StandardButton answer = QMessageBox::question(this, tr("Varimarch"),
    tr("Your measurements, cuts, look and segments are not saved. Save the session?"),
    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
  return answer == QMessageBox::Discard || (answer == QMessageBox::Save && this->SaveSession());
}

// A session names the file of its segments, so they are saved first.
bool MainWindow::SaveSession()
{
  const auto* const file = std::get_if<FileSource>(&this->model.CurrentScene().volume);
  if (file && this->IsTemporary(file->path))
  {
    QMessageBox::information(this, tr("Cannot save"),
      tr("This scan was fetched from an archive and is deleted at the end, so a session could not "
         "find it again. Fetch it with \"Keep in…\" first."));
    return false;
  }
  while (const std::optional<int> unsaved = this->model.VolumeWithUnsavedLabels())
  {
    if (!this->SaveSegmentation(*unsaved))
    {
      return false;
    }
  }
  const QString path = this->model.CurrentStudy()
    ? ChosenFileToSave(this, tr("Save the session"), { tr("Sessions (*.json)") }, "session")
    : QString();
  if (path.isEmpty())
  {
    return false;
  }
  try
  {
    WriteScene(this->model.CurrentScene(), path);
  }
  catch (const std::exception& problem)
  {
    QMessageBox::warning(this, tr("Cannot save"), QString::fromStdString(problem.what()));
    return false;
  }
  this->savedWork = this->CurrentWork();
  this->ShowSaved(path);
  return true;
}

void MainWindow::OfferAutosaved()
{
  if (this->autosave.HasCopy() &&
    QMessageBox::question(this, tr("Varimarch"),
      tr("The program ended unexpectedly last time. Restore your session?")) == QMessageBox::Yes)
  {
    this->Open(this->autosave.Path());
  }
}

// Makes new contexts: that of the window, with which the views share theirs, is lost too.
void MainWindow::RenewGraphics()
{
  constexpr int MostInARow = 2;
  constexpr int GestureMilliseconds = 50;
  if (QGuiApplication::mouseButtons() != Qt::NoButton)
  {
    // A window that is made anew would miss the end of the gesture.
    QTimer::singleShot(GestureMilliseconds, this, &MainWindow::RenewGraphics);
    return;
  }
  LogEvent("graphics card reset");
  const bool goesOn = ++this->resetsInARow < MostInARow;
  if (goesOn)
  {
    // A view drops its context when it leaves a window.
    QWidget* const center = this->takeCentralWidget();
    this->hide();
    this->destroy(true, false);
    this->setCentralWidget(center);
    center->show();
    this->show();
  }
  auto* const box = new QMessageBox(QMessageBox::Warning, tr("Graphics card"),
    goesOn ? tr("The graphics card was reset, and the image is drawn anew; nothing is lost.")
           : tr("The graphics card was reset again before it had drawn an image; save the session "
                "and start the program again, with another driver, or with "
                "LIBGL_ALWAYS_SOFTWARE=1 to draw without the card."),
    QMessageBox::Ok, this);
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->open();
}

void MainWindow::closeEvent(QCloseEvent* event)
{
  if (!this->MayLeaveScan())
  {
    event->ignore();
    return;
  }
  LogEvent("window closed");
  this->loader.Cancel();
  // Without a volume, the copy of an earlier run could not be restored, or has not been yet.
  if (this->model.CurrentStudy())
  {
    this->autosave.Remove();
  }
  this->fetched.clear(); // the program may end before its threads do
  QSettings settings;
  settings.setValue("window/geometry", this->saveGeometry());
  settings.setValue("window/panels", this->saveState());
  QMainWindow::closeEvent(event);
}

void MainWindow::ShowSaved(const QString& path)
{
  this->statusBar()->showMessage(tr("Saved %1").arg(path));
}

}
