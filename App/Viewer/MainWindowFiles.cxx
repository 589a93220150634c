// The part of MainWindow that opens scans and sessions, and exports images.

#include "Viewer/MainWindow.h"

#include "Scene/SceneFile.h"
#include "Viewer/Model/Log.h"
#include "Viewer/Model/VolumeRequests.h"
#include "Viewer/Open/FileKind.h"
#include "Viewer/Open/RawForm.h"
#include "Viewer/Open/SeriesPicker.h"
#include "Viewer/SaveDialog.h"
#include "Viewer/View/ComparisonView.h"
#include "Viewer/View/PictureExport.h"
#include "Viewer/View/VolumeView.h"

#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMimeData>
#include <QRegularExpression>
#include <QSettings>
#include <QStatusBar>
#include <QTimer>
#include <QUrl>

#include <vtkVolumeFileReader.h>

#include <algorithm>

namespace varimarch
{

namespace
{

const QString AskAtStartKey = QStringLiteral("open/askAtStart");

QStringList LocalFiles(const QMimeData& data)
{
  QStringList paths;
  for (const QUrl& url : data.urls())
  {
    if (url.isLocalFile())
    {
      paths << url.toLocalFile();
    }
  }
  return paths;
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
  if (name.isEmpty())
  {
    this->ShowFailure(tr("There is no file to open: its name is empty."));
    return;
  }
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

void MainWindow::OpenTogether(const QStringList& names)
{
  if (names.size() == 1)
  {
    this->Open(names.first());
    return;
  }
  if (!this->MayLeaveScan())
  {
    return;
  }
  this->ForgetRequest();
  std::vector<std::string> paths;
  for (const QString& name : names)
  {
    paths.push_back(QFileInfo(name).absoluteFilePath().toStdString());
  }
  this->BeginLoading(QFileInfo(names.first()).absolutePath());
  this->loader.LoadTogether(paths);
}

// A new request replaces the last one, with all that was to be done after it.
void MainWindow::ForgetRequest()
{
  this->restored.reset();
  this->exchanges = false;
  this->restoresAutosaved = false;
  this->isDropped = false;
  this->isPreviewed = false;
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
  const bool isForItself = !this->exchanges && !this->addsScan && !this->restored;
  this->loader.Load({ source, series, labels, overlays, isForItself });
}

void MainWindow::OpenSample(const VolumeSource& sample)
{
  this->ForgetRequest();
  this->Load(sample);
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
  QMenu* const kinds = menu->addMenu(tr("&Kinds of volume in the series"));
  kinds->setObjectName("kinds");
  kinds->menuAction()->setVisible(false);
  connect(menu, &QMenu::aboutToShow, kinds, [this, kinds] { this->FillKinds(kinds); });
}

// Offers what else the series of the scan holds: other echoes, b-values, views or stations.
void MainWindow::FillKinds(QMenu* kinds)
{
  kinds->clear();
  const auto study = this->model.CurrentStudy();
  const auto* const file =
    study ? std::get_if<FileSource>(&this->model.CurrentScene().volume) : nullptr;
  const std::size_t count = file ? study->volume.kinds.size() : 0;
  kinds->menuAction()->setVisible(count > 1);
  for (std::size_t i = 0; i < count && count > 1; ++i)
  {
    FileSource chosen = *file;
    chosen.kind = int(i) + 1;
    chosen.time = 0;
    chosen.timeSeconds.reset();
    QAction* const action =
      kinds->addAction(QString("%1  %2")
                         .arg(chosen.kind)
                         .arg(QString::fromStdString(study->volume.kinds[i]).replace('&', "&&")));
    action->setCheckable(true);
    action->setChecked(chosen.kind == std::max(file->kind, 1));
    connect(action, &QAction::triggered, this,
      [this, chosen]
      {
        if (this->MayLeaveScan())
        {
          this->ForgetRequest();
          this->Load(chosen);
        }
      });
  }
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
  const QString path = QFileDialog::getOpenFileName(this,
    tr("Open files as times: choose one of the files whose names differ in a number"), {},
    FileFilter());
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

void MainWindow::ListRecentScans()
{
  this->recentMenu->clear();
  for (const RecentScan& scan : this->recentScans.List())
  {
    this->recentMenu->addAction(scan.Title() + ", " + scan.Opened(), this,
      [this, scan] { this->Open(scan.path, scan.series); });
  }
  this->recentMenu->addSeparator();
  this->recentMenu->addAction(tr("Clear the list"), this, [this] { this->recentScans.Clear(); });
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
  if (!LocalFiles(*event->mimeData()).isEmpty())
  {
    event->acceptProposedAction();
  }
}

// The program that the file is dragged from waits for the end of this function.
void MainWindow::dropEvent(QDropEvent* event)
{
  const QStringList paths = LocalFiles(*event->mimeData());
  QTimer::singleShot(0, this,
    [this, paths]
    { paths.size() == 1 ? this->OpenDropped(paths.first()) : this->OpenTogether(paths); });
}

}
