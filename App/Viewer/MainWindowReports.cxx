// The part of MainWindow that writes reports and benchmarks.

#include "Viewer/MainWindow.h"

#include "Viewer/Reports/BenchmarkDialog.h"
#include "Viewer/Reports/ScanReport.h"
#include "Viewer/SaveDialog.h"
#include "Viewer/View/ComparisonView.h"
#include "Viewer/View/VolumeView.h"
#include "Viewer/WaitCursor.h"

#include <QMessageBox>

namespace varimarch
{

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

}
