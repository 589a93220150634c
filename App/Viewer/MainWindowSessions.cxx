// The part of MainWindow that keeps the user's work: sessions, and questions before it is lost.

#include "Viewer/MainWindow.h"

#include "Viewer/Model/Log.h"
#include "Viewer/SaveDialog.h"

#include <QCloseEvent>
#include <QMessageBox>
#include <QSettings>
#include <QStatusBar>

#include <exception>

namespace varimarch
{

QString MainWindow::CurrentWork() const
{
  const auto study = this->model.CurrentStudy();
  return study ? WorkText(this->model.CurrentScene(), *study) : QString();
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

bool MainWindow::SaveSession()
{
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
