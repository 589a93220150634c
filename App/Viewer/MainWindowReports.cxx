// The part of MainWindow that writes reports and benchmarks.

#include "Viewer/MainWindow.h"

#include "Viewer/Reports/BenchmarkDialog.h"
#include "Viewer/Reports/ScanReport.h"
#include "Viewer/View/ComparisonView.h"
#include "Viewer/View/VolumeView.h"

#include <QFileDialog>
#include <QGuiApplication>
#include <QMessageBox>
#include <QStatusBar>

namespace varimarch
{

void MainWindow::ExportReport()
{
  const QString path = this->model.CurrentStudy()
    ? QFileDialog::getSaveFileName(this, tr("Export a report"), "report.pdf", tr("PDF (*.pdf)"))
    : QString();
  if (path.isEmpty())
  {
    return;
  }
  QGuiApplication::setOverrideCursor(Qt::WaitCursor);
  QString problem;
  try
  {
    WriteScanReport(&this->model, path);
  }
  catch (const std::exception& failure)
  {
    problem = QString::fromStdString(failure.what());
  }
  QGuiApplication::restoreOverrideCursor();
  if (problem.isEmpty())
  {
    this->statusBar()->showMessage(tr("Saved %1").arg(path));
  }
  else
  {
    QMessageBox::warning(this, tr("Cannot export"), problem);
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

}
