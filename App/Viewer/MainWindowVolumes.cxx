// The part of MainWindow that adds further scans to the one that is shown, and bounds the memory of
// all.

#include "Viewer/MainWindow.h"

#include "Registration/RigidRegistration.h"
#include "Scene/Overlaying.h"
#include "Scene/PresetSuggestion.h"
#include "Scene/Presets.h"
#include "Viewer/Model/Log.h"
#include "Viewer/Model/MemoryLimit.h"

#include <QActionGroup>
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QFutureWatcher>
#include <QMenu>
#include <QMessageBox>
#include <QProgressDialog>
#include <QPushButton>
#include <QStatusBar>
#include <QTimer>
#include <QtConcurrent>

#include <atomic>
#include <memory>
#include <optional>

namespace varimarch
{

namespace
{

// State shared by the window and the thread that registers.
struct RegistrationWork
{
  std::atomic<bool> stop{ false };
  std::atomic<int> percent{ 0 };
  QString failure; ///< one sentence; set before the thread ends
};

std::optional<Placement> PlacementFound(const std::shared_ptr<const Study>& first,
  const std::shared_ptr<const Study>& moving, const Placement& start, RegistrationWork& work)
{
  try
  {
    return RegisteredPlacement(first->volume.image, moving->volume.image, start,
      [&](double part)
      {
        work.percent = int(100.0 * part);
        return !work.stop;
      });
  }
  catch (const std::exception& problem)
  {
    work.failure = QString::fromStdString(problem.what());
    return std::nullopt;
  }
}

bool HasPlaceForVolume(const Scene& scene)
{
  return scene.overlays.size() + 1 < MostVolumes;
}

}

void MainWindow::ChooseFurtherScan()
{
  if (!this->model.CurrentStudy() || !HasPlaceForVolume(this->model.CurrentScene()))
  {
    return;
  }
  QMessageBox kind(QMessageBox::Question, tr("Add a scan"),
    tr("Where is the scan to draw over the one that is shown?"), QMessageBox::Cancel, this);
  kind.setObjectName("furtherScan");
  const QAbstractButton* const file = kind.addButton(tr("In a file…"), QMessageBox::YesRole);
  const QAbstractButton* const folder =
    kind.addButton(tr("In a folder of DICOM files…"), QMessageBox::NoRole);
  kind.exec();
  const QString path = kind.clickedButton() == file
    ? QFileDialog::getOpenFileName(this, tr("Add a scan"), {}, FileFilter())
    : kind.clickedButton() == folder ? QFileDialog::getExistingDirectory(this, tr("Add a scan"))
                                     : QString();
  if (!path.isEmpty())
  {
    this->AddScan(path);
  }
}

void MainWindow::AddScan(const QString& path)
{
  this->ForgetRequest();
  this->addsScan = true;
  this->Load(FileSource{ QFileInfo(path).absoluteFilePath().toStdString(), std::nullopt });
}

void MainWindow::ShowAdded(const VolumeSource& source, const std::shared_ptr<const Study>& study)
{
  // While it was read, others may have been added, or brought back by redo.
  if (!HasPlaceForVolume(this->model.CurrentScene()))
  {
    this->ShowFailure(
      tr("At most %1 scans are drawn at once: remove one of them, and add the scan again")
        .arg(MostVolumes));
    return;
  }
  const OverlaidVolume overlay = OverlayOf(source, study->volume, study->statistics);
  const CommonSpace space = SpaceOf(this->model.CurrentStudy()->volume, study->volume);
  LogEvent("scan added", { { "count", double(this->model.CurrentScene().overlays.size() + 2) } });
  this->model.AddOverlay(overlay, WithoutLabels(*study), tr("add a scan"));
  this->statusBar()->showMessage(
    tr("Added %1; the look panels now change it").arg(QString::fromStdString(overlay.name)));
  auto* const panel = this->findChild<QDockWidget*>("volumes");
  panel->show();
  panel->raise();
  if (space != CommonSpace::Same)
  {
    auto* const box = new QMessageBox(QMessageBox::Warning, tr("Add a scan"),
      space == CommonSpace::Different
        ? tr("The two scans have different frames of reference: they may not fit on each other. "
             "Check their place in the slices, and move or register the added one.")
        : tr("The files do not say whether the two scans are in the same space. They are placed by "
             "their coordinates: check that in the slices, and move or register the added one."),
      QMessageBox::Ok, this);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setObjectName("otherSpace");
    box->open();
  }
}

// Gives the edited volume its first look again.
void MainWindow::TakeSuggestedLook()
{
  const auto study = this->model.EditedStudy();
  const int edited = this->model.EditedVolume();
  if (edited > 0)
  {
    const VolumeSource& source = this->model.CurrentScene().overlays[edited - 1].source;
    this->model.SetLook(
      OverlayOf(source, study->volume, study->statistics).look, tr("suggested look"));
  }
  else if (study)
  {
    const std::string name = SuggestedPreset(study->volume, study->statistics).name;
    this->model.SetPreset(BuiltInPreset(name), tr("suggested look"));
  }
}

// The dialog is modal to the window, so only a scan that was being loaded before can change the
// volumes meanwhile. A cancelled QProgressDialog only hides, and the next progress shows it again;
// so it is deleted, which ends the search.
void MainWindow::Register(int overlay)
{
  constexpr int PollMilliseconds = 100;
  const auto work = std::make_shared<RegistrationWork>();
  auto* const waiting = new QProgressDialog(tr("Registering"), tr("Cancel"), 0, 100, this);
  waiting->setObjectName("registering");
  waiting->setWindowModality(Qt::WindowModal);
  waiting->setAutoClose(false);
  waiting->setAutoReset(false);
  waiting->setMinimumDuration(0);
  waiting->setValue(0);
  connect(waiting, &QProgressDialog::canceled, waiting, &QObject::deleteLater);
  connect(waiting, &QObject::destroyed, [work] { work->stop = true; });
  auto* const poll = new QTimer(waiting);
  connect(poll, &QTimer::timeout, waiting, [=] { waiting->setValue(work->percent); });
  poll->start(PollMilliseconds);
  const auto study = this->model.CurrentStudy();
  auto* const watcher = new QFutureWatcher<std::optional<Placement>>(waiting);
  connect(watcher, &QFutureWatcherBase::finished, this,
    [=]
    {
      const std::optional<Placement> found = watcher->result();
      waiting->close();
      if (!found)
      {
        QMessageBox::warning(this, tr("Cannot register"), work->failure);
      }
      else if (this->model.CurrentStudy() == study)
      {
        this->TakeRegistered(overlay, *found);
      }
    });
  const Placement start = this->model.CurrentScene().overlays[overlay].placement;
  watcher->setFuture(QtConcurrent::run(
    [=] { return PlacementFound(study, study->overlays[overlay], start, *work); }));
}

void MainWindow::TakeRegistered(int overlay, const Placement& placement)
{
  this->model.Edit(ScenePart::Overlays, tr("register a volume"),
    [&](Scene& scene) { scene.overlays[overlay].placement = placement; });
  this->statusBar()->showMessage(
    tr("Registered; compare the volumes in the slices before you trust it"));
}

void MainWindow::MakeMemoryMenu(QMenu* menu)
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
        this->statusBar()->showMessage(tr("The next volume is read within this memory"));
      });
  }
}

}
