// The part of MainWindow that exports movies in which the scene changes.

#include "Viewer/MainWindow.h"

#include "Scene/Presets.h"
#include "Scene/SceneChange.h"
#include "Scene/VolumeProperty.h"
#include "Viewer/Model/PresetTitles.h"
#include "Viewer/Model/StudyTimes.h"
#include "Viewer/View/ComparisonView.h"
#include "Viewer/View/Movies.h"
#include "Viewer/View/VolumeView.h"

#include <QMenu>

namespace varimarch
{

namespace
{

constexpr int PicturesOfChange = 4 * MoviePicturesPerSecond;

}

void MainWindow::ExportChange(const MovieTexts& texts, const SceneStage& show)
{
  this->ExportMovie(texts,
    [this, show](const QString& path, const std::function<bool(double)>& onProgress)
    {
      this->model.CountSegments();
      const auto study = ShownStudy(this->model);
      PictureMaker maker(
        this->model.CurrentScene(), *study, { this->view->Ours()->size(), false, true });
      return WriteChange(
        maker, PicturesOfChange, [&](double part) { show(maker, *study, part); }, path, onProgress);
    });
}

void MainWindow::ExportCuts()
{
  this->ExportChange({ tr("Export the cuts"), tr("Rendering the cuts"), "cuts" },
    [cuts = this->model.CurrentScene().cuts](PictureMaker& maker, const Study& study, double part)
    { maker.SetCuts(CutsOnTheirWay(cuts, study.volume.image, part)); });
}

void MainWindow::ExportLookChange(const std::string& preset)
{
  const Look to = this->model.CurrentScene().look;
  const Look from =
    InUnitsOfData(BuiltInPreset(preset).look, this->model.CurrentStudy()->statistics);
  this->ExportChange({ tr("Export a change of the look"), tr("Rendering the change"), "look" },
    [from, to](PictureMaker& maker, const Study&, double part)
    { maker.SetLook(LookBetween(from, to, part)); });
}

// The looks that can change into the current one.
void MainWindow::ListLooksToChange(QMenu* menu)
{
  menu->clear();
  const Look& look = this->model.CurrentScene().look;
  for (const std::string& name : PresetNames())
  {
    const Look preset = BuiltInPreset(name).look;
    if (Suits(preset, this->model.CurrentStudy()->statistics) && CanChange(preset, look))
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

void MainWindow::MakeChangeActions(QMenu* file)
{
  QAction* const cuts = file->addAction(tr("Export the &cuts…"), this, &MainWindow::ExportCuts);
  cuts->setObjectName("exportCuts");
  QMenu* const looks = file->addMenu(tr("Export a cha&nge of the look from"));
  looks->setObjectName("exportLookChange");
  connect(looks, &QMenu::aboutToShow, this, [this, looks] { this->ListLooksToChange(looks); });
  for (QAction* const action : { cuts, looks->menuAction() })
  {
    action->setEnabled(false);
  }
  connect(&this->model, &SceneModel::Changed, this,
    [this, cuts, looks]
    {
      const SceneCuts& made = this->model.CurrentScene().cuts;
      cuts->setEnabled(made.box != SceneCuts().box || !made.planes.empty());
      looks->menuAction()->setEnabled(true);
    });
}

}
