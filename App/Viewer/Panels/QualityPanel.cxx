#include "Viewer/Panels/QualityPanel.h"

#include "Viewer/Panels/NumberSlider.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>

#include <algorithm>
#include <array>
#include <cmath>

namespace varimarch
{

namespace
{

// Error tolerances to choose from, as 1/n of full brightness.
constexpr std::array<int, 6> Parts = { 8, 16, 32, 64, 128, 255 };

}

QualityPanel::QualityPanel(SceneModel* model, QWidget* parent)
  : QWidget(parent)
  , model(model)
  , form(new QFormLayout(this))
{
  this->MakeError();
  this->MakePromise();
  this->MakeInterpolation();
  this->MakeDetail();
  connect(model, &SceneModel::Changed, this, &QualityPanel::Show);
  this->setEnabled(false);
}

void QualityPanel::MakeError()
{
  this->error = new QSlider(Qt::Horizontal);
  this->error->setObjectName("error");
  this->error->setRange(0, int(Parts.size()) - 1);
  this->error->setPageStep(1);
  this->error->setTickPosition(QSlider::TicksBelow);
  this->error->setAccessibleName(tr("Largest error"));
  this->text = new QLabel;
  this->form->addRow(tr("Fast"), this->error);
  this->form->addRow(tr("Error at most"), this->text);
  connect(this->error, &QSlider::valueChanged, this,
    [this](int position)
    {
      this->Edit(tr("quality"),
        [position](RenderOptions& render) { render.errorTolerance = 1.0 / Parts[position]; });
    });
}

void QualityPanel::MakePromise()
{
  this->promises = new QCheckBox(tr("Promise the error"));
  this->promises->setObjectName("promises");
  this->promises->setToolTip(
    tr("Otherwise all steps are as long as the spacing of the voxels suggests"));
  connect(this->promises, &QCheckBox::clicked, this,
    [this](bool on)
    {
      this->Edit(tr("promise of the error"),
        [on](RenderOptions& render)
        { render.errorTolerance = on ? RenderOptions().errorTolerance : 0.0; });
    });
  this->end = new NumberSlider(0.0001, 0.5, NumberSlider::Scale::Logarithmic);
  this->end->setObjectName("end");
  this->end->setToolTip(tr("A ray ends where less than this part of the light behind it is left"));
  connect(this->end, &NumberSlider::Edited, this,
    [this](double transmittance, int gesture)
    {
      this->Edit(
        tr("end of rays"),
        [transmittance](RenderOptions& render)
        { render.earlyTerminationTransmittance = transmittance; },
        gesture);
    });
  this->form->addRow(this->promises);
  this->form->addRow(tr("Rays end at"), this->end);
}

void QualityPanel::MakeInterpolation()
{
  const std::tuple<Interpolation, QString, QString> kinds[] = {
    { Interpolation::Nearest, tr("None: voxels are boxes"),
      tr("The values as they were measured") },
    { Interpolation::Linear, tr("Linear"), tr("The fastest") },
    { Interpolation::Cubic, tr("Cubic"), tr("A spline: edges have no staircases") },
  };
  this->interpolation = new QComboBox;
  this->interpolation->setObjectName("interpolation");
  // The entries are longer in some languages, and must not widen the panel.
  this->interpolation->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  this->interpolation->setMinimumContentsLength(8);
  for (const auto& [kind, name, purpose] : kinds)
  {
    this->interpolation->addItem(name, int(kind));
    this->interpolation->setItemData(this->interpolation->count() - 1, purpose, Qt::ToolTipRole);
  }
  connect(this->interpolation, QOverload<int>::of(&QComboBox::activated), this,
    [this](int index)
    {
      const auto kind = Interpolation(this->interpolation->itemData(index).toInt());
      this->Edit(
        tr("interpolation"), [kind](RenderOptions& render) { render.interpolation = kind; });
    });
  this->jitter = new QCheckBox(tr("Jitter"));
  this->jitter->setObjectName("jitter");
  this->jitter->setToolTip(tr("Turns the rings that long steps leave into fine grain"));
  connect(this->jitter, &QCheckBox::clicked, this,
    [this](bool on)
    { this->Edit(tr("jitter"), [on](RenderOptions& render) { render.jitter = on; }); });
  this->form->addRow(tr("Interpolation"), this->interpolation);
  this->form->addRow(this->jitter);
}

void QualityPanel::MakeDetail()
{
  this->refined = new QCheckBox(tr("Read only what the image needs"));
  this->refined->setObjectName("refined");
  this->refined->setToolTip(
    tr("Coarse voxels stay where they change the image by less than half of the error"));
  connect(this->refined, &QCheckBox::clicked, this,
    [this](bool on)
    {
      this->Edit(tr("what is read"),
        [on](RenderOptions& render)
        { render.level = on ? VolumeLevel::Refined : RenderOptions().level; });
    });
  this->form->addRow(this->refined);
}

void QualityPanel::Edit(
  const QString& name, const std::function<void(RenderOptions&)>& change, int gesture)
{
  this->model->Edit(
    ScenePart::Render, name, [&](Scene& scene) { change(scene.render); }, gesture);
}

void QualityPanel::Show()
{
  this->setEnabled(true);
  const QSignalBlocker quiet(this->error);
  const RenderOptions& render = this->model->CurrentScene().render;
  const bool promised = render.errorTolerance > 0.0;
  const double parts = 1.0 / std::max(render.errorTolerance, 1.0 / Parts.back());
  const auto nearest = std::min_element(Parts.begin(), Parts.end(),
    [parts](int a, int b) { return std::abs(a - parts) < std::abs(b - parts); });
  this->error->setValue(int(nearest - Parts.begin()));
  this->error->setEnabled(promised);
  this->text->setText(
    promised ? tr("1/%1 of full brightness").arg(int(std::lround(parts))) : tr("not promised"));
  this->promises->setChecked(promised);
  this->end->SetNumber(render.earlyTerminationTransmittance);
  this->end->setVisible(!promised);
  this->form->labelForField(this->end)->setVisible(!promised);
  this->interpolation->setCurrentIndex(this->interpolation->findData(int(render.interpolation)));
  this->jitter->setChecked(render.jitter);
  this->refined->setChecked(render.level == VolumeLevel::Refined);
  this->refined->setVisible(this->model->CurrentStudy()->volume.isOnDisk);
}

}
