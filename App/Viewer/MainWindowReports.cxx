// The part of MainWindow that exports images, movies, reports and benchmarks.

#include "Viewer/MainWindow.h"

#include "Viewer/Model/StudyTimes.h"
#include "Viewer/Panels/KeyImagesBox.h"
#include "Viewer/Panels/TimeBar.h"
#include "Viewer/Reports/BenchmarkDialog.h"
#include "Viewer/Reports/ScanReport.h"
#include "Viewer/SaveDialog.h"
#include "Viewer/View/ComparisonView.h"
#include "Viewer/View/Movies.h"
#include "Viewer/View/VolumeView.h"
#include "Viewer/WaitCursor.h"

#include <QCoreApplication>
#include <QMenu>
#include <QMessageBox>
#include <QProgressDialog>
#include <QVBoxLayout>

namespace varimarch
{

void MainWindow::ExportMovie(const MovieTexts& texts,
  const std::function<bool(const QString&, const std::function<bool(double)>&)>& write)
{
  constexpr int Steps = 100;
  const QString path = ChosenFileToSave(this, texts.title, TurntableFilters(), texts.name);
  if (path.isEmpty())
  {
    return;
  }
  QProgressDialog waiting(texts.waiting, tr("Cancel"), 0, Steps, this);
  waiting.setWindowModality(Qt::WindowModal);
  waiting.setMinimumDuration(0);
  try
  {
    const bool isComplete = write(path,
      [&](double part)
      {
        waiting.setValue(int(part * Steps));
        QCoreApplication::processEvents();
        return !waiting.wasCanceled();
      });
    if (isComplete)
    {
      this->ShowSaved(path);
    }
  }
  catch (const std::exception& problem)
  {
    // A reader that is cancelled fails.
    if (!waiting.wasCanceled())
    {
      QMessageBox::warning(this, tr("Cannot export"), QString::fromStdString(problem.what()));
    }
  }
}

void MainWindow::ExportTurntable()
{
  constexpr int Pictures = 72;
  if (!this->model.CurrentStudy())
  {
    return;
  }
  this->ExportMovie({ tr("Export a turntable"), tr("Rendering the turntable"), "turntable" },
    [this](const QString& path, const std::function<bool(double)>& onProgress)
    {
      this->model.CountSegments();
      PictureMaker maker(this->model.CurrentScene(), *ShownStudy(this->model),
        { this->view->Ours()->size(), false, true });
      return WriteTurntable(maker, Pictures, path, onProgress);
    });
}

// The speed is that of the bar of the times.
void MainWindow::ExportTimes()
{
  this->ExportMovie({ tr("Export the times"), tr("Rendering the times"), "times" },
    [this](const QString& path, const std::function<bool(double)>& onProgress)
    {
      this->model.CountSegments();
      const WrittenTimes written =
        WriteTimesMovie({ this->model.CurrentScene(), this->model.CurrentStudy(),
                          { this->view->Ours()->size(), false, true }, this->timeBar->Speed() },
          path, onProgress);
      if (written.isComplete && !written.problem.isEmpty())
      {
        QMessageBox::warning(this, tr("Export the times"),
          tr("An added scan stays at the time before, since another could not be read: %1")
            .arg(written.problem));
      }
      return written.isComplete;
    });
}

void MainWindow::ExportReport()
{
  const QString path = this->model.CurrentStudy()
    ? ChosenFileToSave(this, tr("Export a report"), { tr("PDF (*.pdf)") }, "report")
    : QString();
  if (path.isEmpty())
  {
    return;
  }
  try
  {
    const WaitCursor cursor;
    WriteScanReport(&this->model, path);
    this->ShowSaved(path);
  }
  catch (const std::exception& problem)
  {
    QMessageBox::warning(this, tr("Cannot export"), QString::fromStdString(problem.what()));
  }
}

void MainWindow::ShowBenchmark()
{
  if (this->model.CurrentStudy())
  {
    auto* const dialog = new BenchmarkDialog(&this->model, this->view->Ours()->size(), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->show();
  }
}

void MainWindow::MakeExportActions(QMenu* file)
{
  file->addAction(tr("Export an &image…"), this, &MainWindow::ExportPicture, QKeySequence("Ctrl+E"))
    ->setObjectName("exportImage");
  file->addAction(tr("Send the i&mage to an archive…"), this, &MainWindow::SendPicture)
    ->setObjectName("sendImage");
  file->addAction(tr("Export a &turntable…"), this, &MainWindow::ExportTurntable);
  QAction* const movie = file->addAction(tr("&Export the times…"), this, &MainWindow::ExportTimes);
  movie->setObjectName("exportTimes");
  movie->setEnabled(false);
  connect(&this->model, &SceneModel::Changed, movie,
    [this, movie] { movie->setEnabled(this->model.CurrentStudy()->volume.times.AreSeveral()); });
  this->MakeChangeActions(file);
  file->addAction(tr("Export a re&port…"), this, &MainWindow::ExportReport)
    ->setObjectName("exportReport");
}

QWidget* MainWindow::WithKeyImages(QWidget* measures)
{
  auto* const both = new QWidget;
  auto* const column = new QVBoxLayout(both);
  column->setContentsMargins(0, 0, 0, 0);
  this->keyImages = new KeyImagesBox(&this->model);
  column->addWidget(measures, 3);
  column->addWidget(this->keyImages, 1);
  return both;
}

}
