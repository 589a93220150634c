#include "Viewer/Panels/FusionBar.h"

#include "Viewer/Panels/NumberSlider.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>

namespace varimarch
{

FusionBar::FusionBar(SceneModel* model, QWidget* parent)
  : QWidget(parent)
  , model(model)
  , blend(new NumberSlider(0.0, 1.0, NumberSlider::Scale::Linear))
  , checkerboard(new QCheckBox(tr("Checkerboard")))
{
  this->blend->setAccessibleName(tr("Blend of the volumes"));
  this->blend->setToolTip(tr("0 shows the first volume, 1 those over it"));
  this->checkerboard->setObjectName("checkerboard");
  this->checkerboard->setToolTip(tr("Shows the volumes in alternate squares of 20 mm"));
  auto* const row = new QHBoxLayout(this);
  row->setContentsMargins(6, 2, 6, 2);
  row->addWidget(new QLabel(tr("Blend")));
  row->addWidget(this->blend, 1);
  row->addWidget(this->checkerboard);
  connect(this->blend, &NumberSlider::Edited, this,
    [this](double number, int gesture)
    {
      this->model->Edit(
        ScenePart::Slices, tr("blend of the volumes"),
        [=](Scene& scene) { scene.slices.fusionOpacity = number; }, gesture);
    });
  connect(this->checkerboard, &QCheckBox::clicked, this,
    [this](bool on)
    {
      this->model->Edit(ScenePart::Slices, tr("checkerboard"),
        [on](Scene& scene)
        { scene.slices.fusion = on ? SliceFusion::Checkerboard : SliceFusion::Blend; });
    });
  connect(model, &SceneModel::Changed, this, &FusionBar::Show);
  this->hide();
}

void FusionBar::Show(ScenePart part)
{
  if (part != ScenePart::Volume && part != ScenePart::Slices && part != ScenePart::Overlays)
  {
    return;
  }
  const Scene& scene = this->model->CurrentScene();
  this->setVisible(!scene.overlays.empty());
  this->blend->SetNumber(scene.slices.fusionOpacity);
  this->blend->setEnabled(scene.slices.fusion == SliceFusion::Blend);
  this->checkerboard->setChecked(scene.slices.fusion == SliceFusion::Checkerboard);
}

}
