#include "Viewer/Panels/SlabBar.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>

namespace varimarch
{

namespace
{

constexpr double ThickestMm = 100.0;

}

SlabBar::SlabBar(SceneModel* model, QWidget* parent)
  : QWidget(parent)
  , model(model)
  , thickness(new QDoubleSpinBox)
  , blend(new QComboBox)
  , straighten(new QToolButton)
{
  // Items in the order of SlabBlend.
  this->blend->addItems({ tr("Maximum"), tr("Minimum"), tr("Mean") });
  this->blend->setAccessibleName(tr("Blend mode of the slab"));
  this->thickness->setRange(0.0, ThickestMm);
  this->thickness->setDecimals(1);
  this->thickness->setSuffix(tr(" mm"));
  this->thickness->setAccessibleName(tr("Thickness of the slices"));
  this->thickness->setKeyboardTracking(false);
  this->setToolTip(
    tr("A slab shows the largest, the smallest or the mean value over its thickness"));
  auto* const row = new QHBoxLayout(this);
  row->setContentsMargins(6, 2, 6, 2);
  row->addWidget(new QLabel(tr("Slab")));
  row->addWidget(this->thickness, 1);
  row->addWidget(this->blend);
  this->straighten->setText(tr("Straighten"));
  this->straighten->setToolTip(tr("Show axial, coronal and sagittal slices again"));
  row->addWidget(this->straighten);
  connect(this->thickness, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
    [this](double millimetres)
    {
      this->model->Edit(ScenePart::Slices, tr("slab"),
        [millimetres](Scene& scene) { scene.slices.slabMm = millimetres; });
    });
  connect(this->blend, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
    [this](int index)
    {
      this->model->Edit(ScenePart::Slices, tr("slab"),
        [index](Scene& scene) { scene.slices.slabBlend = SlabBlend(index); });
    });
  connect(this->straighten, &QToolButton::clicked, this,
    [this]
    {
      this->model->Edit(ScenePart::Slices, tr("straighten the slices"),
        [](Scene& scene) { scene.slices.turn = {}; });
    });
  connect(model, &SceneModel::Changed, this, &SlabBar::Show);
  this->setEnabled(false);
}

void SlabBar::Show(ScenePart part)
{
  if (part != ScenePart::Volume && part != ScenePart::Slices)
  {
    return;
  }
  this->setEnabled(true);
  const SliceSettings& slices = this->model->CurrentScene().slices;
  const QSignalBlocker quiet[] = { QSignalBlocker(this->thickness), QSignalBlocker(this->blend) };
  this->thickness->setValue(slices.slabMm);
  this->blend->setCurrentIndex(int(slices.slabBlend));
  this->straighten->setEnabled(slices.turn != SliceTurn());
}

}
