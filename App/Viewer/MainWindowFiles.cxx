// The part of MainWindow that opens scans and sessions, and exports images.

#include "Viewer/MainWindow.h"

#include "Scene/SceneFile.h"
#include "Viewer/Model/Log.h"
#include "Viewer/Model/PresetTitles.h"
#include "Viewer/Open/FileKind.h"
#include "Viewer/Open/RawForm.h"
#include "Viewer/Open/SeriesPicker.h"
#include "Viewer/Open/WarningBar.h"
#include "Viewer/SaveDialog.h"
#include "Viewer/View/ComparisonView.h"
#include "Viewer/View/PictureExport.h"
#include "Viewer/View/VolumeView.h"

#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QProgressBar>
#include <QPushButton>
#include <QRegularExpression>
#include <QSettings>
#include <QStatusBar>
#include <QTimer>
#include <QUrl>

#include <vtkVolumeFileReader.h>

#include <utility>

namespace varimarch
{

namespace
{

const QString AskAtStartKey = QStringLiteral("open/askAtStart");

void LogVolume(const LoadedVolume& volume)
{
  const int* const count = volume.image->GetDimensions();
  LogEvent("volume opened",
    { { "columns", double(count[0]) }, { "rows", double(count[1]) }, { "slices", double(count[2]) },
      { "bytes per value", double(volume.image->GetScalarSize()) },
      { "warnings", double(volume.warnings.size()) } });
}

}

// Filter of a file dialog: "Volumes (*.nrrd *.nhdr ...)", then a line for each format.
QString MainWindow::FileFilter()
{
  QStringList all;
  QStringList formats;
  for (int format = 0; format < vtkVolumeFileReader::GetNumberOfFormats(); ++format)
  {
    const QStringList extensions =
      QString::fromStdString(vtkVolumeFileReader::GetFormatExtensions(format))
        .split(' ', Qt::SkipEmptyParts)
        .replaceInStrings(QRegularExpression("^"), "*");
    all += extensions;
    formats += QStringLiteral("%1 (%2)").arg(
      vtkVolumeFileReader::GetFormatDescription(format), extensions.join(' '));
  }
  formats.prepend(tr("Volumes (%1)").arg(all.join(' ')));
  formats.append(tr("All files (*)"));
  return formats.join(";;");
}

void MainWindow::Open(const QString& name, const QString& series)
{
  if (!this->MayLeaveScan())
  {
    return;
  }
  this->ForgetRequest();
  // A session in another folder must find the scan too.
  const QString path = QFileInfo(name).absoluteFilePath();
  this->restoresAutosaved = path == QFileInfo(this->autosave.Path()).absoluteFilePath();
  const std::optional<FileKind> kind = KindOfFile(path);
  if (!kind)
  {
    this->ShowFailure(
      tr("\"%1\" does not answer: its disk or the network may be gone. Try again later.")
        .arg(path));
    return;
  }
  if (*kind == FileKind::BareVoxels)
  {
    this->AskForLayout(path);
    return;
  }
  if (*kind == FileKind::Volume)
  {
    this->Load(FileSource{ path.toStdString(), std::nullopt }, series);
    return;
  }
  try
  {
    this->restored = ReadScene(path.toStdString());
    this->Load(this->restored->volume, {}, this->restored->labels, this->restored->overlays);
  }
  catch (const std::exception& problem)
  {
    this->ShowFailure(QString::fromStdString(problem.what()));
  }
}

// A new request replaces the last one, with all that was to be done after it.
void MainWindow::ForgetRequest()
{
  this->restored.reset();
  this->exchanges = false;
  this->restoresAutosaved = false;
  this->isDropped = false;
  this->addsScan = false;
  this->segmentations.clear();
}

void MainWindow::BeginLoading(const QString& path)
{
  LogEvent("loading");
  this->ShowLoading(true);
  this->statusBar()->showMessage(tr("Loading %1").arg(QFileInfo(path).fileName()));
}

void MainWindow::Load(const VolumeSource& source, const QString& series,
  const std::optional<SceneLabels>& labels, const std::vector<OverlaidVolume>& overlays)
{
  const auto* const file = std::get_if<FileSource>(&source);
  this->BeginLoading(file ? QString::fromStdString(file->path) : QString());
  this->loader.Load(source, series, labels, overlays);
}

void MainWindow::AskForLayout(const QString& path)
{
  auto* const form = new RawForm(path, this);
  form->setAttribute(Qt::WA_DeleteOnClose);
  connect(form, &RawForm::Chosen, this, [this](const FileSource& source) { this->Load(source); });
  form->open();
}

void MainWindow::AskForSeries(const FileSource& source, const std::vector<SeriesSummary>& series)
{
  LogEvent("series to choose from", { { "count", double(series.size()) } });
  this->ShowLoading(false);
  this->statusBar()->clearMessage();
  auto* const picker = new SeriesPicker(series, this);
  picker->setAttribute(Qt::WA_DeleteOnClose);
  connect(picker, &SeriesPicker::Chosen, this,
    [this, source](const QString& uid)
    {
      FileSource chosen = source;
      chosen.series = uid.toStdString();
      this->Load(chosen);
    });
  picker->open();
}

void MainWindow::MakeOpenActions(QMenu* menu)
{
  menu->addAction(tr("&Open…"), this, &MainWindow::ChooseFile, QKeySequence::Open);
  menu->addAction(
    tr("Open a &folder…"), this, &MainWindow::ChooseFolder, QKeySequence("Ctrl+Shift+O"));
  menu->addAction(tr("Open a ra&w file…"), this, &MainWindow::ChooseRawFile);
  menu->addAction(tr("Open fi&les as times…"), this, &MainWindow::ChooseTimes)
    ->setObjectName("openTimes");
}

void MainWindow::ChooseFile()
{
  const QString path = QFileDialog::getOpenFileName(this, tr("Open a volume"), {}, FileFilter());
  if (!path.isEmpty())
  {
    this->Open(path);
  }
}

void MainWindow::MakeAskAtStartAction(QMenu* menu)
{
  QAction* const ask = menu->addAction(tr("&Ask for a scan at start"));
  ask->setObjectName("askAtStart");
  ask->setCheckable(true);
  ask->setChecked(QSettings().value(AskAtStartKey).toBool());
  connect(ask, &QAction::triggered, ask, [](bool on) { QSettings().setValue(AskAtStartKey, on); });
}

// The dialog waits for the window to be shown.
void MainWindow::OfferFileAtStart()
{
  if (QSettings().value(AskAtStartKey).toBool() && !this->model.CurrentStudy() &&
    !this->loader.IsLoading())
  {
    QTimer::singleShot(0, this, &MainWindow::ChooseFile);
  }
}

void MainWindow::ChooseFolder()
{
  const QString path = QFileDialog::getExistingDirectory(this, tr("Open a folder of DICOM files"));
  if (!path.isEmpty())
  {
    this->Open(path);
  }
}

void MainWindow::ChooseTimes()
{
  const QString path = QFileDialog::getOpenFileName(
    this, tr("Open files as times: choose one of those that differ in a number"), {}, FileFilter());
  if (!path.isEmpty())
  {
    this->OpenTimes(path);
  }
}

void MainWindow::OpenTimes(const QString& path)
{
  if (!this->MayLeaveScan())
  {
    return;
  }
  this->ForgetRequest();
  FileSource source = { QFileInfo(path).absoluteFilePath().toStdString(), std::nullopt };
  source.filesAreTimes = true;
  this->Load(source);
}

void MainWindow::ChooseRawFile()
{
  const QString path =
    QFileDialog::getOpenFileName(this, tr("Open a raw file"), {}, tr("All files (*)"));
  if (!path.isEmpty() && this->MayLeaveScan())
  {
    this->ForgetRequest();
    this->AskForLayout(path);
  }
}

void MainWindow::ExportPicture()
{
  if (this->model.CurrentStudy())
  {
    ExportDialog dialog(&this->model, this->view->Ours()->size(), this);
    if (dialog.exec() == QDialog::Accepted)
    {
      this->ShowSaved(dialog.Path());
    }
  }
}

// A coarse copy, until the volume itself has been read, or for good if that is cancelled.
void MainWindow::ShowPreview(const VolumeSource& source, const std::shared_ptr<const Study>& study)
{
  if (this->exchanges || this->addsScan || this->restored)
  {
    return;
  }
  LogVolume(study->volume);
  this->model.Open(source, study);
  this->savedWork = this->CurrentWork();
  this->statusBar()->showMessage(
    tr("A coarse copy is shown until the volume has been read for the first time"));
}

bool MainWindow::ShowsPreviewOf(const VolumeSource& source) const
{
  const std::shared_ptr<const Study> shown = this->model.CurrentStudy();
  const auto* const file = std::get_if<FileSource>(&source);
  const auto* const shownFile = std::get_if<FileSource>(&this->model.CurrentScene().volume);
  return shown && shown->volume.isPreview && file && shownFile && file->path == shownFile->path;
}

// Returns false if the user keeps the scan that is shown.
bool MainWindow::TakeLoaded(const VolumeSource& source, const std::shared_ptr<const Study>& study)
{
  const bool completes = !this->restored && this->ShowsPreviewOf(source);
  const bool losesLabels = completes && this->model.HasUnsavedLabels();
  if ((std::exchange(this->isDropped, false) || losesLabels) && !this->MayLeaveScan())
  {
    return false;
  }
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
  return true;
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
  this->savedWork = this->restoresAutosaved ? QString() : this->CurrentWork();
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

void MainWindow::ShowWarnings()
{
  const Study& study = *this->model.CurrentStudy();
  const SliceLayout slices = study.volume.slices;
  const QString remedy = slices == SliceLayout::Irregular ? tr("Rectify")
    : slices == SliceLayout::Rectified                    ? tr("Show as scanned")
                                                          : QString();
  this->warnings->Show(WarningBar::TextsOf(study), remedy);
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

void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
  if (event->mimeData()->hasUrls() && event->mimeData()->urls().first().isLocalFile())
  {
    event->acceptProposedAction();
  }
}

// The program that the file is dragged from waits for the end of this function.
void MainWindow::dropEvent(QDropEvent* event)
{
  const QString path = event->mimeData()->urls().first().toLocalFile();
  QTimer::singleShot(0, this, [this, path] { this->OpenDropped(path); });
}

}
