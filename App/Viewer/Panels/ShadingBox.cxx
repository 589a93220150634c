#include "Viewer/Panels/ShadingBox.h"

#include "Scene/ShadingPresets.h"
#include "Scene/VolumeProperty.h"
#include "Viewer/Panels/NumberSlider.h"

#include <QComboBox>
#include <QFormLayout>

namespace varimarch
{

namespace
{

QString WordFor(const std::string& kind)
{
  const std::pair<const char*, QString> words[] = {
    { "soft", ShadingBox::tr("Soft") },
    { "clinical", ShadingBox::tr("Clinical") },
    { "glossy", ShadingBox::tr("Glossy") },
    { "flat", ShadingBox::tr("Flat: unshaded colours") },
  };
  for (const auto& [name, word] : words)
  {
    if (kind == name)
    {
      return word;
    }
  }
  return QString::fromStdString(kind);
}

}

ShadingBox::ShadingBox(SceneModel* model, QWidget* parent)
  : QGroupBox(tr("Light and shading"), parent)
  , model(model)
  , form(new QFormLayout(this))
{
  this->setObjectName("shading");
  this->setCheckable(true);
  connect(this, &QGroupBox::clicked, this,
    [this](bool on)
    {
      Shading shading = this->model->EditedLook().shading;
      shading.enabled = on;
      this->Edit(tr("shading"), shading, SceneModel::NoGesture);
    });
  this->MakeKinds();
  using Scale = NumberSlider::Scale;
  this->AddCoefficient(tr("Ambient"), &Shading::ambient, new NumberSlider(0, 1, Scale::Linear));
  this->AddCoefficient(tr("Diffuse"), &Shading::diffuse, new NumberSlider(0, 1, Scale::Linear));
  this->AddCoefficient(tr("Specular"), &Shading::specular, new NumberSlider(0, 1, Scale::Linear));
  this->AddCoefficient(
    tr("Power"), &Shading::specularPower, new NumberSlider(1, 1000, Scale::Logarithmic));
  this->MakeDamping();
  connect(model, &SceneModel::Changed, this, &ShadingBox::Update);
}

void ShadingBox::MakeKinds()
{
  this->kinds = new QComboBox;
  this->kinds->setObjectName("lights");
  for (const auto& preset : ShadingPresets())
  {
    this->kinds->addItem(WordFor(preset.first));
  }
  connect(this->kinds, QOverload<int>::of(&QComboBox::activated), this,
    [this](int index)
    {
      if (index < int(ShadingPresets().size()))
      {
        this->Edit(tr("light"), ShadingPresets()[index].second, SceneModel::NoGesture);
      }
    });
  this->form->addRow(tr("Kind"), this->kinds);
}

void ShadingBox::AddCoefficient(
  const QString& name, double Shading::*coefficient, NumberSlider* slider)
{
  slider->setObjectName(name);
  connect(slider, &NumberSlider::Edited, this,
    [=](double number, int gesture)
    {
      Shading shading = this->model->EditedLook().shading;
      shading.*coefficient = number;
      this->Edit(name.toLower(), shading, gesture);
    });
  this->form->addRow(name, slider);
  this->sliders.emplace_back(slider, coefficient);
}

void ShadingBox::MakeDamping()
{
  this->damping = new NumberSlider(0, 1, NumberSlider::Scale::Linear);
  this->damping->setObjectName("damping");
  this->damping->setToolTip(
    tr("Gradient below which light other than ambient weakens, so that noise "
       "in homogeneous material does not glitter"));
  connect(this->damping, &NumberSlider::Edited, this,
    [this](double gradient, int gesture)
    {
      Look look = this->model->EditedLook();
      look.dampingGradient = gradient;
      this->model->SetLook(look, tr("damping"), gesture);
    });
  this->form->addRow(tr("Damping"), this->damping);
}

// Noise has gradients of a few percent of the range of the values per voxel.
void ShadingBox::ShowDampingOf(const Study& study)
{
  constexpr double LargestPart = 0.1;
  const ImageStatistics& statistics = study.statistics;
  const double range = statistics.Percentile(99.9) - statistics.Percentile(0.1);
  const double largest = LargestPart * range / MeanSpacingMm(study.volume.image);
  this->damping->SetRange(0.0, largest > 0.0 ? largest : 1.0);
  this->damping->SetSuffix(study.volume.modality == "CT" ? tr(" HU/mm") : tr(" per mm"));
}

void ShadingBox::Edit(const QString& name, const Shading& shading, int gesture)
{
  Look look = this->model->EditedLook();
  look.shading = shading;
  this->model->SetLook(look, name, gesture);
}

void ShadingBox::Update(ScenePart part)
{
  if (part != ScenePart::Look && !IsOtherLookVolume(part))
  {
    return;
  }
  if (IsOtherLookVolume(part))
  {
    this->ShowDampingOf(*this->model->EditedStudy());
  }
  const Look& look = this->model->EditedLook();
  this->damping->SetNumber(look.dampingGradient);
  this->setVisible(look.blend == Blend::Composite || look.blend == Blend::Isosurface);
  this->setChecked(look.shading.enabled);
  // A custom shading has an additional last row while it is shown.
  const int presetCount = int(ShadingPresets().size());
  this->kinds->removeItem(presetCount);
  const auto name = NameOfShading(look.shading);
  if (!name)
  {
    this->kinds->addItem(tr("Custom"));
  }
  this->kinds->setCurrentIndex(name ? this->kinds->findText(WordFor(*name)) : presetCount);
  // A disabled group box disables its children, but the list stays usable without light.
  this->kinds->setEnabled(true);
  for (const auto& [slider, coefficient] : this->sliders)
  {
    slider->SetNumber(look.shading.*coefficient);
  }
}

}
