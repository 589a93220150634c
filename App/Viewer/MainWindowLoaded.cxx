// The part of MainWindow that shows what was loaded.

#include "Viewer/MainWindow.h"

#include "Scene/SingleImage.h"
#include "Viewer/Model/Log.h"
#include "Viewer/Model/PresetTitles.h"
#include "Viewer/Open/WarningBar.h"
#include "Viewer/View/SliceView.h"
#include "Viewer/View/ViewLayout.h"

#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QStatusBar>

#include <memory>
#include <utility>

namespace varimarch
{

namespace
{

void LogVolume(const LoadedVolume& volume)
{
  const int* const count = volume.image->GetDimensions();
  LogEvent("volume opened",
    { { "columns", double(count[0]) }, { "rows", double(count[1]) }, { "slices", double(count[2]) },
      { "bytes per value", double(volume.image->GetScalarSize()) },
      { "warnings", double(volume.warnings.size()) } });
}

}

// A coarse copy, until the volume itself has been read, or for good if that is cancelled.
void MainWindow::ShowPreview(const VolumeSource& source, const std::shared_ptr<const Study>& study)
{
  LogVolume(study->volume);
  this->model.Open(source, study);
  this->isPreviewed = true;
  this->savedWork = this->CurrentWork();
  this->statusBar()->showMessage(
    tr("A coarse copy is shown until the volume has been read for the first time"));
}

// Returns false if the user keeps the scan that is shown. What was done with a coarse copy is kept
// and stays unsaved.
bool MainWindow::TakeLoaded(const VolumeSource& source, const std::shared_ptr<const Study>& study)
{
  const bool completes =
    std::exchange(this->isPreviewed, false) && this->model.CurrentStudy()->volume.isPreview;
  const bool losesLabels = completes && this->model.HasUnsavedLabels();
  if ((std::exchange(this->isDropped, false) || losesLabels) && !this->MayLeaveScan())
  {
    return false;
  }
  const bool isUnsaved = completes && this->CurrentWork() != this->savedWork;
  if (this->restored)
  {
    this->restored->volume = source;
    this->ForgetAutosavedFile(*this->restored);
    this->model.Restore(*this->restored, study);
    this->restored.reset();
  }
  else if (completes)
  {
    this->model.Complete(study);
  }
  else
  {
    this->model.Open(source, study);
  }
  this->savedWork = this->restoresAutosaved || isUnsaved ? QString() : this->CurrentWork();
  this->ArrangeSingleImage();
  this->LookForSeries(source);
  return true;
}

// A single image, such as a radiograph, fills the window. In 3D and from its edges it is a line.
void MainWindow::ArrangeSingleImage()
{
  const auto single = SingleImageOf(this->model.CurrentStudy()->volume.image);
  if (single)
  {
    this->views->ShowAlone(this->sliceViews[std::size_t(single->plane)]);
  }
  else if (this->isSingleImage)
  {
    this->views->ShowAlone(nullptr);
  }
  this->isSingleImage = bool(single);
}

// Offers the series of a single image, which may lie beside it.
void MainWindow::LookForSeries(const VolumeSource& source)
{
  this->seriesSearch.Cancel();
  const auto* const file = std::get_if<FileSource>(&source);
  if (!this->isSingleImage || !file || !file->series.empty())
  {
    return;
  }
  const auto found = std::make_shared<std::optional<WholeSeries>>();
  this->seriesSearch.Start([path = file->path, found](const TaskProgress& goesOn)
    { *found = WholeSeriesOf(path, goesOn); },
    [this, found]
    {
      this->wholeSeries = *found;
      this->ShowWarnings(false);
    });
}

void MainWindow::ShowLoaded(const VolumeSource& source, const std::shared_ptr<const Study>& study)
{
  LogVolume(study->volume);
  this->ShowLoading(false);
  if (std::exchange(this->exchanges, false))
  {
    this->Exchange(source, study);
    return;
  }
  if (std::exchange(this->addsScan, false))
  {
    this->ShowAdded(source, study);
    return;
  }
  if (!this->TakeLoaded(source, study))
  {
    return;
  }
  if (const auto* const file = std::get_if<FileSource>(&source))
  {
    this->KeepInMind(*file, *study);
  }
  if (study->labels)
  {
    this->statusBar()->showMessage(tr("Segments: %1").arg(study->labels->segments.size()));
    this->RaiseSegments();
    return;
  }
  this->ShowSuggestion(*study);
}

// Says why the scan has its first look.
void MainWindow::ShowSuggestion(const Study& study)
{
  this->statusBar()->showMessage(
    tr("Look \"%1\": %2. Press R to restore it.")
      .arg(PresetTitle(this->model.CurrentScene().look.name),
        SuggestionText(SuggestedPreset(study.volume, study.statistics))));
}

// Edits of segments and of names leave a bar closed that the user has closed.
void MainWindow::ShowWarnings(bool isNewVolume)
{
  const Study& study = *this->model.CurrentStudy();
  const SliceLayout slices = study.volume.slices;
  QString remedy = slices == SliceLayout::Irregular ? tr("Rectify")
    : slices == SliceLayout::Rectified              ? tr("Show as scanned")
                                                    : QString();
  std::vector<ScanWarning> found = WarningBar::WarningsOf(this->model.CurrentScene(), study);
  if (isNewVolume)
  {
    this->wholeSeries.reset();
  }
  if (this->wholeSeries)
  {
    remedy = tr("Open all images");
    found.push_back({ study.labelGuard,
      tr("This image belongs to a series of %1 images.").arg(this->wholeSeries->imageCount), {} });
  }
  if (isNewVolume)
  {
    this->warnings->Show(found, remedy);
  }
  else
  {
    this->warnings->Update(found, remedy);
  }
}

void MainWindow::TakeRemedy()
{
  if (this->wholeSeries)
  {
    this->Open(
      QString::fromStdString(this->wholeSeries->folder), DigestOfSeries(this->wholeSeries->uid));
  }
  else
  {
    this->ToggleRectified();
  }
}

// Segments are read anew for the other grid, so they are saved before.
void MainWindow::ToggleRectified()
{
  if (this->model.HasUnsavedLabels() && !this->SaveSegmentation(0))
  {
    return;
  }
  VolumeSource source = this->model.CurrentScene().volume;
  auto& file = std::get<FileSource>(source);
  file.rectified = this->model.CurrentStudy()->volume.slices != SliceLayout::Rectified;
  const std::shared_ptr<const Study> known = this->model.ExchangedStudy();
  // Labels lie on the grid of one form of the scan.
  const std::optional<SceneLabels>& labels = this->model.CurrentScene().labels;
  if (known && !labels && known->volume.slices != this->model.CurrentStudy()->volume.slices)
  {
    this->Exchange(source, known);
  }
  else if (!this->loader.IsLoading())
  {
    this->exchanges = true;
    this->Load(source, {}, labels);
  }
}

void MainWindow::Exchange(const VolumeSource& source, const std::shared_ptr<const Study>& form)
{
  const bool isRectified = form->volume.slices == SliceLayout::Rectified;
  this->model.Exchange(
    source, form, isRectified ? tr("rectify slices") : tr("show slices as scanned"));
  this->statusBar()->clearMessage();
}

void MainWindow::ShowFailure(const QString& reason)
{
  LogEvent("opening failed");
  emit this->OpeningFailed(reason);
  this->ShowLoading(false);
  this->statusBar()->showMessage(reason);
  auto* const box =
    new QMessageBox(QMessageBox::Warning, tr("Cannot open"), reason, QMessageBox::Ok, this);
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->open();
}

void MainWindow::ShowLoading(bool loading)
{
  this->progress->setVisible(loading);
  this->progress->setValue(0);
  this->cancel->setVisible(loading);
}

}
