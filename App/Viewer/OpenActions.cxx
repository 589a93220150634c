#include "Viewer/OpenActions.h"

#include "Scene/Json/SceneFile.h"
#include "Scene/Looks/Presets.h"
#include "Scene/Volumes/RawGuess.h"
#include "Viewer/Model/BackgroundTask.h"
#include "Viewer/Model/Log.h"
#include "Viewer/Model/OwnPresets.h"
#include "Viewer/Model/SessionFile.h"
#include "Viewer/Model/StudyTimes.h"
#include "Viewer/Open/LoadController.h"
#include "Viewer/Open/RawForm.h"
#include "Viewer/Open/SeriesPicker.h"
#include "Viewer/PanelTabs.h"
#include "Viewer/SaveActions.h"
#include "Viewer/ScanLists.h"

#include <QActionGroup>
#include <QFileDialog>
#include <QFileInfo>
#include <QMainWindow>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QRegularExpression>
#include <QSettings>
#include <QStatusBar>
#include <QTimer>
#include <QUrl>

#include <vtkVolumeFileReader.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <iterator>

namespace varimarch
{

namespace
{

const QString AskAtStartKey = QStringLiteral("open/askAtStart");

/// Files that are opened in different ways.
enum class FileKind
{
  BareVoxels, ///< their form is asked for
  Scene,      ///< also sessions
  Volume,     ///< also what is missing or unknown, so that reading it tells the reason
};

// Empty if the file's disk does not answer for seconds.
std::optional<FileKind> KindOfFile(const QString& path)
{
  return ResultInTime(
    [path = path.toStdString()]
    {
      std::error_code ignored;
      if (IsBareVoxels(path) && std::filesystem::exists(path, ignored))
      {
        return FileKind::BareVoxels;
      }
      return IsSceneFile(path) ? FileKind::Scene : FileKind::Volume;
    });
}

std::string AbsolutePath(const QString& path)
{
  return QFileInfo(path).absoluteFilePath().toStdString();
}

// Filter of a file dialog: "Volumes (*.nrrd *.nhdr ...)", then a line for each format.
QString FileFilter()
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
  formats.prepend(OpenActions::tr("Volumes (%1)").arg(all.join(' ')));
  formats.append(OpenActions::tr("All files (*)"));
  return formats.join(";;");
}

bool MayBelongTo(const LoadedVolume& scan, const SeriesSummary& segmentation)
{
  return scan.frameOfReference.empty() || segmentation.frameOfReference.empty() ||
    scan.frameOfReference == segmentation.frameOfReference;
}

}

OpenActions::OpenActions(const Context& context, QMainWindow* window)
  : QObject(window)
  , context(context)
  , window(window)
{
  this->Listen();
}

void OpenActions::Listen()
{
  const LoadController* const loader = this->context.loader;
  connect(loader, &LoadController::Began, this,
    [this](const QString& path)
    { this->window->statusBar()->showMessage(tr("Loading %1").arg(QFileInfo(path).fileName())); });
  connect(loader, &LoadController::Previewed, this,
    [this]
    {
      this->window->statusBar()->showMessage(
        tr("A coarse copy is shown until the volume has been read for the first time"));
    });
  connect(loader, &LoadController::Cancelled, this,
    [this] { this->window->statusBar()->showMessage(tr("Loading was cancelled")); });
  connect(loader, &LoadController::FormShown, this,
    [this] { this->window->statusBar()->clearMessage(); });
  connect(loader, &LoadController::SeriesFound, this, &OpenActions::AskForSeries);
  connect(loader, &LoadController::LabelsFound, this, &OpenActions::AskForLabels);
  connect(loader, &LoadController::Opened, this, &OpenActions::TellOpened);
  connect(loader, &LoadController::Added, this, &OpenActions::TellAdded);
  connect(loader, &LoadController::LabelsShown, this, &OpenActions::TellLabels);
  connect(loader, &LoadController::Failed, this, &OpenActions::TellFailure);
  connect(this->context.lists, &ScanLists::ScanWanted, this, &OpenActions::Open);
}

void OpenActions::AddTo(QMenu* menu)
{
  menu->addAction(tr("&Open…"), this, &OpenActions::ChooseFile, QKeySequence::Open);
  menu->addAction(
    tr("Open a &folder…"), this, &OpenActions::ChooseFolder, QKeySequence("Ctrl+Shift+O"));
  menu->addAction(tr("Open a ra&w file…"), this, &OpenActions::ChooseRawFile);
  menu->addAction(tr("Open fi&les as times…"), this, &OpenActions::ChooseTimes)
    ->setObjectName("openTimes");
  QMenu* const kinds = menu->addMenu(tr("&Kinds of volume in the series"));
  kinds->setObjectName("kinds");
  kinds->menuAction()->setVisible(false);
  connect(menu, &QMenu::aboutToShow, kinds, [this, kinds] { this->FillKinds(kinds); });
  QAction* const further =
    menu->addAction(tr("A&dd a scan…"), this, &OpenActions::ChooseFurtherScan);
  further->setObjectName("addScan");
  QAction* const segmentation =
    menu->addAction(tr("Open a se&gmentation…"), this, &OpenActions::ChooseSegmentation);
  segmentation->setObjectName("openSegmentation");
  for (QAction* const action : { further, segmentation })
  {
    action->setEnabled(false);
    connect(
      this->context.model, &SceneModel::Changed, action, [action] { action->setEnabled(true); });
  }
}

void OpenActions::AddSettingsTo(QMenu* menu)
{
  QAction* const ask = menu->addAction(tr("&Ask for a scan at start"));
  ask->setObjectName("askAtStart");
  ask->setCheckable(true);
  ask->setChecked(QSettings().value(AskAtStartKey).toBool());
  connect(ask, &QAction::triggered, ask, [](bool on) { QSettings().setValue(AskAtStartKey, on); });
  this->FillMemory(menu->addMenu(tr("Memor&y for volumes")));
}

void OpenActions::FillMemory(QMenu* menu)
{
  auto* const choices = new QActionGroup(this);
  for (const int gigabytes : { 0, 2, 4, 8, 16, 32, 64 })
  {
    QAction* const action = choices->addAction(
      menu->addAction(gigabytes == 0 ? tr("&All of the computer's") : tr("%1 GB").arg(gigabytes)));
    action->setObjectName(QStringLiteral("memory%1").arg(gigabytes));
    action->setCheckable(true);
    action->setChecked(gigabytes == ChosenMemoryGigabytes());
    connect(action, &QAction::triggered, this,
      [this, gigabytes]
      {
        ChooseMemoryGigabytes(gigabytes);
        this->window->statusBar()->showMessage(tr("The next volume is read within this memory"));
      });
  }
}

// Offers what else the series of the scan holds: other echoes, b-values, views or stations.
void OpenActions::FillKinds(QMenu* kinds)
{
  kinds->clear();
  const auto study = this->context.model->CurrentStudy();
  const auto* const file =
    study ? std::get_if<FileSource>(&this->context.model->CurrentScene().volume) : nullptr;
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
        if (this->context.saving->MayLeaveScan())
        {
          this->context.loader->Start(NewScan{ chosen });
        }
      });
  }
}

void OpenActions::Open(const QString& name, const QString& series)
{
  if (name.isEmpty())
  {
    this->TellFailure(tr("There is no file to open: its name is empty."));
    return;
  }
  if (!this->context.saving->MayLeaveScan())
  {
    return;
  }
  // A session in another folder must find the scan too.
  const QString path = QFileInfo(name).absoluteFilePath();
  const std::optional<FileKind> kind = KindOfFile(path);
  if (!kind)
  {
    this->TellFailure(
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
    this->context.loader->Start(NewScan{ FileSource{ path.toStdString(), std::nullopt }, series });
    return;
  }
  try
  {
    const bool isAutosaved = path == QFileInfo(this->context.autosave->Path()).absoluteFilePath();
    this->context.loader->Start(SavedSession{ ReadScene(path.toStdString()), isAutosaved });
  }
  catch (const std::exception& problem)
  {
    this->TellFailure(QString::fromStdString(problem.what()));
  }
}

void OpenActions::OpenTogether(const QStringList& names)
{
  if (names.size() == 1)
  {
    this->Open(names.first());
    return;
  }
  if (!this->context.saving->MayLeaveScan())
  {
    return;
  }
  ScanOfFiles scan;
  std::transform(names.begin(), names.end(), std::back_inserter(scan.paths), AbsolutePath);
  this->context.loader->Start(scan);
}

void OpenActions::OpenTimes(const QString& path)
{
  if (this->context.saving->MayLeaveScan())
  {
    FileSource source = { AbsolutePath(path), std::nullopt };
    source.filesAreTimes = true;
    this->context.loader->Start(NewScan{ source });
  }
}

void OpenActions::OpenSample(const VolumeSource& sample)
{
  this->context.loader->Start(NewScan{ sample });
}

void OpenActions::AddScan(const QString& path)
{
  this->context.loader->Start(AddedScan{ FileSource{ AbsolutePath(path), std::nullopt } });
}

// Folders and sessions are opened.
void OpenActions::OpenDropped(const QStringList& paths)
{
  const std::string name = paths.first().toStdString();
  const bool mayBeSegmentation = paths.size() == 1 && this->context.model->CurrentStudy() &&
    KindOfFile(paths.first()) == FileKind::Volume && !MayHoldSeveralSeries({ name, std::nullopt });
  if (mayBeSegmentation)
  {
    this->context.loader->StartDropped(name);
  }
  else
  {
    this->OpenTogether(paths);
  }
}

QStringList OpenActions::LocalFiles(const QMimeData& data)
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

void OpenActions::OfferAutosaved()
{
  if (this->context.autosave->HasCopy() &&
    QMessageBox::question(this->window, tr("Varimarch"),
      tr("The program ended unexpectedly last time. Restore your session?")) == QMessageBox::Yes)
  {
    this->Open(this->context.autosave->Path());
  }
}

// The dialog waits for the window to be shown.
void OpenActions::OfferFileAtStart()
{
  if (QSettings().value(AskAtStartKey).toBool() && !this->context.model->CurrentStudy() &&
    !this->context.loader->IsLoading())
  {
    QTimer::singleShot(0, this, &OpenActions::ChooseFile);
  }
}

void OpenActions::ChooseFile()
{
  const QString path =
    QFileDialog::getOpenFileName(this->window, tr("Open a volume"), {}, FileFilter());
  if (!path.isEmpty())
  {
    this->Open(path);
  }
}

void OpenActions::ChooseFolder()
{
  const QString path =
    QFileDialog::getExistingDirectory(this->window, tr("Open a folder of DICOM files"));
  if (!path.isEmpty())
  {
    this->Open(path);
  }
}

void OpenActions::ChooseTimes()
{
  const QString path = QFileDialog::getOpenFileName(this->window,
    tr("Open files as times: choose one of the files whose names differ in a number"), {},
    FileFilter());
  if (!path.isEmpty())
  {
    this->OpenTimes(path);
  }
}

void OpenActions::ChooseRawFile()
{
  const QString path =
    QFileDialog::getOpenFileName(this->window, tr("Open a raw file"), {}, tr("All files (*)"));
  if (!path.isEmpty() && this->context.saving->MayLeaveScan())
  {
    this->AskForLayout(path);
  }
}

void OpenActions::ChooseFurtherScan()
{
  if (!this->context.model->CurrentStudy() || !this->context.loader->HasPlaceForScan())
  {
    return;
  }
  QMessageBox kind(QMessageBox::Question, tr("Add a scan"),
    tr("Where is the scan to draw over the one that is shown?"), QMessageBox::Cancel, this->window);
  kind.setObjectName("furtherScan");
  const QAbstractButton* const file = kind.addButton(tr("In a file…"), QMessageBox::YesRole);
  const QAbstractButton* const folder =
    kind.addButton(tr("In a folder of DICOM files…"), QMessageBox::NoRole);
  kind.exec();
  const QString path = kind.clickedButton() == file
    ? QFileDialog::getOpenFileName(this->window, tr("Add a scan"), {}, FileFilter())
    : kind.clickedButton() == folder
    ? QFileDialog::getExistingDirectory(this->window, tr("Add a scan"))
    : QString();
  if (!path.isEmpty())
  {
    this->AddScan(path);
  }
}

void OpenActions::ChooseSegmentation()
{
  const QString path = this->context.model->CurrentStudy()
    ? QFileDialog::getOpenFileName(
        this->window, tr("Open a segmentation of this scan"), {}, FileFilter())
    : QString();
  if (!path.isEmpty())
  {
    this->context.loader->StartLabels({ path.toStdString() }, this->context.model->EditedVolume());
  }
}

void OpenActions::AskForLayout(const QString& path)
{
  auto* const form = new RawForm(path, this->window);
  form->setAttribute(Qt::WA_DeleteOnClose);
  connect(form, &RawForm::Chosen, this,
    [this](const FileSource& source) { this->context.loader->Start(NewScan{ source }); });
  form->open();
}

void OpenActions::AskForSeries(const LoadRequest& request, const LoadResult& found)
{
  this->window->statusBar()->clearMessage();
  auto* const picker = new SeriesPicker(found.series, this->window);
  picker->setAttribute(Qt::WA_DeleteOnClose);
  connect(picker, &SeriesPicker::Chosen, this,
    [this, request, found](const QString& uid)
    { this->context.loader->Start(WithSeries(request, found, uid.toStdString())); });
  picker->open();
}

// Asks what a file of few whole values is.
void OpenActions::AskForLabels(const LoadRequest& request, const LoadResult& found)
{
  auto* const box = new QMessageBox(QMessageBox::Question, tr("Varimarch"),
    tr("This file may be a segmentation of the scan that is shown: it lies in the same place, and "
       "has %1 different whole values. Show it as segments of the scan?")
      .arg(found.labelled->labels->segments.size()),
    QMessageBox::NoButton, this->window);
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setObjectName("possibleSegmentation");
  QPushButton* const asSegments = box->addButton(tr("Show as segments"), QMessageBox::YesRole);
  QPushButton* const asScan = box->addButton(tr("Open as a scan"), QMessageBox::NoRole);
  box->addButton(QMessageBox::Cancel);
  connect(asSegments, &QAbstractButton::clicked, this,
    [=] { this->context.loader->ShowLabels(request, found); });
  connect(asScan, &QAbstractButton::clicked, this,
    [=] { this->context.loader->ShowAsScan(request, found); });
  box->open();
}

void OpenActions::OfferSegmentations(
  const FileSource& folder, const std::vector<SeriesSummary>& segmentations)
{
  const auto study = this->context.model->CurrentStudy();
  std::vector<SeriesSummary> offered;
  std::copy_if(segmentations.begin(), segmentations.end(), std::back_inserter(offered),
    [&](const SeriesSummary& one) { return MayBelongTo(study->volume, one); });
  if (offered.empty() || study->labels)
  {
    return;
  }
  auto* const box = new QMessageBox(QMessageBox::Question, tr("Varimarch"),
    tr("Beside the scan the folder holds a segmentation. Show its segments?"),
    QMessageBox::Yes | QMessageBox::No, this->window);
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setObjectName("foundSegmentation");
  connect(box->button(QMessageBox::Yes), &QAbstractButton::clicked, this,
    [=] { this->OpenOffered(folder, offered); });
  box->open();
}

void OpenActions::OpenOffered(const FileSource& folder, const std::vector<SeriesSummary>& offered)
{
  const auto open = [this, path = folder.path](const std::string& uid) {
    this->context.loader->StartLabels({ path, uid }, this->context.model->EditedVolume());
  };
  if (offered.size() == 1)
  {
    open(offered.front().uid);
    return;
  }
  auto* const picker = new SeriesPicker(offered, this->window);
  picker->setAttribute(Qt::WA_DeleteOnClose);
  connect(
    picker, &SeriesPicker::Chosen, this, [open](const QString& uid) { open(uid.toStdString()); });
  picker->open();
}

// Says why the scan has its first look, or that it has segments.
void OpenActions::TellOpened(
  const VolumeSource& source, const std::vector<SeriesSummary>& segmentations)
{
  const auto study = this->context.model->CurrentStudy();
  if (const auto* const file = std::get_if<FileSource>(&source))
  {
    this->context.lists->Remember(*file, *study);
    this->OfferSegmentations(*file, segmentations);
  }
  if (study->labels)
  {
    this->TellLabels(int(study->labels->segments.size()));
    return;
  }
  this->window->statusBar()->showMessage(
    tr("Look \"%1\": %2. Press R to restore it.")
      .arg(PresetTitle(this->context.model->CurrentScene().look.name),
        SuggestionText(SuggestedPreset(study->volume, study->statistics))));
}

void OpenActions::TellAdded(const QString& name, CommonSpace space)
{
  this->window->statusBar()->showMessage(tr("Added %1; the look panels now change it").arg(name));
  RaisePanel(this->window, "volumes");
  if (space != CommonSpace::Same)
  {
    auto* const box = new QMessageBox(QMessageBox::Warning, tr("Add a scan"),
      space == CommonSpace::Different
        ? tr("The two scans have different frames of reference: they may not fit on each other. "
             "Check their place in the slices, and move or register the added one.")
        : tr("The files do not say whether the two scans are in the same space. They are placed by "
             "their coordinates: check that in the slices, and move or register the added one."),
      QMessageBox::Ok, this->window);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setObjectName("otherSpace");
    box->open();
  }
}

void OpenActions::TellLabels(int segmentCount)
{
  this->window->statusBar()->showMessage(tr("Segments: %1").arg(segmentCount));
  RaisePanel(this->window, "segments");
}

void OpenActions::TellFailure(const QString& reason)
{
  LogEvent("opening failed");
  emit this->Failed(reason);
  this->window->statusBar()->showMessage(reason);
  auto* const box =
    new QMessageBox(QMessageBox::Warning, tr("Cannot open"), reason, QMessageBox::Ok, this->window);
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->open();
}

}
