#include "Viewer/Panels/LightEffectsBox.h"

#include "Scene/Presets.h"
#include "Scene/SceneLights.h"
#include "Viewer/Panels/NumberSlider.h"

#include <QFormLayout>
#include <QPushButton>
#include <QVBoxLayout>

#include <optional>
#include <string>

namespace varimarch
{

namespace
{

// The light that suits a preset; nothing for other looks.
std::optional<Lighting> LightOfPreset(const std::string& name)
{
  return IsPresetName(name) ? BuiltInPreset(name).light : std::nullopt;
}

}

LightEffectsBox::LightEffectsBox(SceneModel* model, QWidget* parent)
  : QWidget(parent)
  , model(model)
{
  auto* const column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  this->MakeSuited();
  column->addWidget(this->suited);
  column->addLayout(this->MakeShadows());
  column->addLayout(this->MakeScattering());
  column->addLayout(this->MakeOcclusion());
  connect(model, &SceneModel::Changed, this, &LightEffectsBox::Show);
}

void LightEffectsBox::MakeSuited()
{
  this->suited = new QPushButton(tr("Light that suits the look"));
  this->suited->setObjectName("suitedLight");
  this->suited->setToolTip(tr("Replaces all of this by the light of the preset."));
  connect(this->suited, &QPushButton::clicked, this,
    [this]
    {
      const std::optional<Lighting> light = LightOfPreset(this->model->CurrentScene().look.name);
      this->model->Edit(
        ScenePart::Lights, tr("light of the preset"),
        [&](Scene& scene) { TakeLighting(light.value(), scene); }, SceneModel::NoGesture);
    });
}

NumberSlider* LightEffectsBox::MakeSlider(const char* name, const std::array<double, 2>& range,
  const QString& step, const std::function<double&(Scene&)>& numberOf)
{
  auto* const slider = new NumberSlider(range[0], range[1], NumberSlider::Scale::Linear);
  slider->setObjectName(name);
  connect(slider, &NumberSlider::Edited, this,
    [=](double number, int gesture)
    {
      this->model->Edit(
        ScenePart::Lights, step, [&](Scene& scene) { numberOf(scene) = number; }, gesture);
    });
  return slider;
}

QFormLayout* LightEffectsBox::MakeShadows()
{
  auto* const rows = new QFormLayout;
  this->shadows = this->MakeSlider(
    "shadows", { 0.0, 1.0 }, tr("shadows"), [](Scene& scene) -> double& { return scene.shadows; });
  this->shadows->setToolTip(tr(
    "How dark the shadows are that volumes cast on themselves and on each other, from lights that "
    "are not at the eye; 0 is off. An image takes about three times as long."));
  rows->addRow(tr("Shadows"), this->shadows);
  return rows;
}

QFormLayout* LightEffectsBox::MakeScattering()
{
  auto* const rows = new QFormLayout;
  const QString step = tr("scattering");
  this->scattering = this->MakeSlider("scattering", { 0.0, 1.0 }, step,
    [](Scene& scene) -> double& { return scene.scattering.blending; });
  this->scattering->setToolTip(
    tr("The part of the light that matter scatters and surfaces do not reflect; 0 is off."));
  this->anisotropy = this->MakeSlider("anisotropy", { -0.95, 0.95 }, step,
    [](Scene& scene) -> double& { return scene.scattering.anisotropy; });
  this->anisotropy->setToolTip(
    tr("Scattered light mostly goes back below 0, and straight on above."));
  this->scatteringReach = this->MakeSlider("scatteringReach", { 0.0, 1.0 }, step,
    [](Scene& scene) -> double& { return scene.scattering.reach; });
  this->scatteringReach->setToolTip(
    tr("How far matter dims scattered light without shadows: 0 not at all, 1 everywhere."));
  rows->addRow(tr("Scattering"), this->scattering);
  rows->addRow(tr("Forward"), this->anisotropy);
  rows->addRow(tr("Dimmed within"), this->scatteringReach);
  return rows;
}

QFormLayout* LightEffectsBox::MakeOcclusion()
{
  constexpr double LongestReachMm = 100.0;
  auto* const rows = new QFormLayout;
  const QString step = tr("ambient occlusion");
  this->occlusion = this->MakeSlider("occlusion", { 0.0, 1.0 }, step,
    [](Scene& scene) -> double& { return scene.occlusion.strength; });
  this->occlusion->setToolTip(
    tr("How much darker places are that see little of what is around the volume; 0 is off."));
  this->reach = this->MakeSlider("occlusionReach", { 0.0, LongestReachMm }, step,
    [](Scene& scene) -> double& { return scene.occlusion.reachMm; });
  this->reach->SetSuffix(tr(" mm"));
  this->reach->setToolTip(tr("Matter farther away does not occlude. 0 stands for 16 voxels."));
  rows->addRow(tr("Occlusion"), this->occlusion);
  rows->addRow(tr("Reach"), this->reach);
  return rows;
}

void LightEffectsBox::Show(ScenePart part)
{
  const Scene& scene = this->model->CurrentScene();
  if (part == ScenePart::Look || part == ScenePart::Volume)
  {
    this->suited->setEnabled(LightOfPreset(scene.look.name).has_value());
  }
  if (part == ScenePart::Lights || part == ScenePart::Volume)
  {
    this->shadows->SetNumber(scene.shadows);
    this->scattering->SetNumber(scene.scattering.blending);
    this->anisotropy->SetNumber(scene.scattering.anisotropy);
    this->scatteringReach->SetNumber(scene.scattering.reach);
    this->occlusion->SetNumber(scene.occlusion.strength);
    this->reach->SetNumber(scene.occlusion.reachMm);
  }
}

}
