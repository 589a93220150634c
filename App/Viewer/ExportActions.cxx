#include "Viewer/ExportActions.h"

#include "Scene/Looks/Presets.h"
#include "Scene/Looks/VolumeProperty.h"
#include "Scene/Model/SceneChange.h"
#include "Viewer/Archives/SendDialog.h"
#include "Viewer/Dialogs.h"
#include "Viewer/Model/OwnPresets.h"
#include "Viewer/Model/SceneModel.h"
#include "Viewer/Model/StudyTimes.h"
#include "Viewer/Panels/ViewBars.h"
#include "Viewer/Reports/ScanReport.h"
#include "Viewer/View/Movies.h"
#include "Viewer/View/PictureExport.h"

#include <QCoreApplication>
#include <QMainWindow>
#include <QMenu>
#include <QMessageBox>
#include <QProgressDialog>

namespace varimarch
{

namespace
{

constexpr int PicturesOfChange = 4 * MoviePicturesPerSecond;

}

ExportActions::ExportActions(const Context& context, QMainWindow* window)
  : QObject(window)
  , model(context.model)
  , view(context.view)
  , timeBar(context.timeBar)
  , window(window)
{
}

void ExportActions::AddTo(QMenu* file)
{
  file
    ->addAction(
      tr("Export an &image…"), this, &ExportActions::ExportPicture, QKeySequence("Ctrl+E"))
    ->setObjectName("exportImage");
  file->addAction(tr("Send the i&mage to an archive…"), this, &ExportActions::SendPicture)
    ->setObjectName("sendImage");
  file->addAction(tr("Export a &turntable…"), this, &ExportActions::ExportTurntable);
  QAction* const movie =
    file->addAction(tr("&Export the times…"), this, &ExportActions::ExportTimes);
  movie->setObjectName("exportTimes");
  movie->setEnabled(false);
  connect(this->model, &SceneModel::Changed, movie,
    [this, movie] { movie->setEnabled(this->model->CurrentStudy()->volume.times.AreSeveral()); });
  this->AddChangesTo(file);
  file->addAction(tr("Export a re&port…"), this, &ExportActions::ExportReport)
    ->setObjectName("exportReport");
}

void ExportActions::AddChangesTo(QMenu* file)
{
  QAction* const cuts = file->addAction(tr("Export the &cuts…"), this, &ExportActions::ExportCuts);
  cuts->setObjectName("exportCuts");
  QMenu* const looks = file->addMenu(tr("Export a cha&nge of the look from"));
  looks->setObjectName("exportLookChange");
  connect(looks, &QMenu::aboutToShow, this, [this, looks] { this->ListLooksToChange(looks); });
  for (QAction* const action : { cuts, looks->menuAction() })
  {
    action->setEnabled(false);
  }
  connect(this->model, &SceneModel::Changed, this,
    [this, cuts, looks]
    {
      const SceneCuts& made = this->model->CurrentScene().cuts;
      cuts->setEnabled(made.box != SceneCuts().box || !made.planes.empty());
      looks->menuAction()->setEnabled(true);
    });
}

void ExportActions::ExportPicture()
{
  if (this->model->CurrentStudy())
  {
    ExportDialog dialog(this->model, this->view->size(), this->window);
    if (dialog.exec() == QDialog::Accepted)
    {
      emit this->Saved(dialog.Path());
    }
  }
}

void ExportActions::SendPicture()
{
  if (this->model->CurrentStudy())
  {
    (new SendDialog(this->model, this->view->size(), this->window))->show();
  }
}

void ExportActions::ExportMovie(const MovieTexts& texts,
  const std::function<bool(const QString&, const std::function<bool(double)>&)>& write)
{
  constexpr int Steps = 100;
  const QString path = ChosenFileToSave(this->window, texts.title, TurntableFilters(), texts.name);
  if (path.isEmpty())
  {
    return;
  }
  QProgressDialog waiting(texts.waiting, tr("Cancel"), 0, Steps, this->window);
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
      emit this->Saved(path);
    }
  }
  catch (const std::exception& problem)
  {
    // A reader that is cancelled fails.
    if (!waiting.wasCanceled())
    {
      QMessageBox::warning(
        this->window, tr("Cannot export"), QString::fromStdString(problem.what()));
    }
  }
}

void ExportActions::ExportTurntable()
{
  constexpr int Pictures = 72;
  if (!this->model->CurrentStudy())
  {
    return;
  }
  this->ExportMovie({ tr("Export a turntable"), tr("Rendering the turntable"), "turntable" },
    [this](const QString& path, const std::function<bool(double)>& onProgress)
    {
      this->model->CountSegments();
      PictureMaker maker(this->model->CurrentScene(), *ShownStudy(*this->model),
        { this->view->size(), false, true });
      return WriteTurntable(maker, Pictures, path, onProgress);
    });
}

// The speed is that of the bar of the times.
void ExportActions::ExportTimes()
{
  this->ExportMovie({ tr("Export the times"), tr("Rendering the times"), "times" },
    [this](const QString& path, const std::function<bool(double)>& onProgress)
    {
      this->model->CountSegments();
      const WrittenTimes written =
        WriteTimesMovie({ this->model->CurrentScene(), this->model->CurrentStudy(),
                          { this->view->size(), false, true }, this->timeBar->Speed() },
          path, onProgress);
      if (written.isComplete && !written.problem.isEmpty())
      {
        QMessageBox::warning(this->window, tr("Export the times"),
          tr("An added scan stays at the time before, since another could not be read: %1")
            .arg(written.problem));
      }
      return written.isComplete;
    });
}

void ExportActions::ExportReport()
{
  const QString path = this->model->CurrentStudy()
    ? ChosenFileToSave(this->window, tr("Export a report"), { tr("PDF (*.pdf)") }, "report")
    : QString();
  if (path.isEmpty())
  {
    return;
  }
  try
  {
    const WaitCursor cursor;
    WriteScanReport(this->model, path);
    emit this->Saved(path);
  }
  catch (const std::exception& problem)
  {
    QMessageBox::warning(this->window, tr("Cannot export"), QString::fromStdString(problem.what()));
  }
}

void ExportActions::ExportChange(const MovieTexts& texts, const SceneStage& show)
{
  this->ExportMovie(texts,
    [this, show](const QString& path, const std::function<bool(double)>& onProgress)
    {
      this->model->CountSegments();
      const auto study = ShownStudy(*this->model);
      PictureMaker maker(this->model->CurrentScene(), *study, { this->view->size(), false, true });
      return WriteChange(
        maker, PicturesOfChange, [&](double part) { show(maker, *study, part); }, path, onProgress);
    });
}

void ExportActions::ExportCuts()
{
  this->ExportChange({ tr("Export the cuts"), tr("Rendering the cuts"), "cuts" },
    [cuts = this->model->CurrentScene().cuts](PictureMaker& maker, const Study& study, double part)
    { maker.SetCuts(CutsOnTheirWay(cuts, study.volume.image, part)); });
}

void ExportActions::ExportLookChange(const std::string& preset)
{
  const Look to = this->model->CurrentScene().look;
  const Look from =
    InUnitsOfData(BuiltInPreset(preset).look, this->model->CurrentStudy()->statistics);
  this->ExportChange({ tr("Export a change of the look"), tr("Rendering the change"), "look" },
    [from, to](PictureMaker& maker, const Study&, double part)
    { maker.SetLook(LookBetween(from, to, part)); });
}

// The looks that can change into the current one.
void ExportActions::ListLooksToChange(QMenu* menu)
{
  menu->clear();
  const Look& look = this->model->CurrentScene().look;
  for (const std::string& name : PresetNames())
  {
    const Look preset = BuiltInPreset(name).look;
    if (Suits(preset, this->model->CurrentStudy()->statistics) && CanChange(preset, look))
    {
      menu->addAction(PresetTitle(name), this, [this, name] { this->ExportLookChange(name); })
        ->setObjectName(QString::fromStdString(name));
    }
  }
  if (menu->isEmpty())
  {
    menu->addAction(tr("The current look cannot change: it is no composite, or has regions"))
      ->setEnabled(false);
  }
}

}
