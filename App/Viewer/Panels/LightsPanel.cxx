#include "Viewer/Panels/LightsPanel.h"

#include "Scene/Looks/Presets.h"
#include "Scene/Model/SceneCuts.h"
#include "Scene/Model/SceneLights.h"
#include "Viewer/Dialogs.h"
#include "Viewer/Panels/NumberSlider.h"

#include <QColorDialog>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QPixmap>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <optional>
#include <string>

namespace varimarch
{

namespace
{

struct LightText
{
  LightKind kind;
  QString name;
};

std::vector<LightText> LightTexts()
{
  return {
    { LightKind::Head, LightsPanel::tr("At the eye") },
    { LightKind::Camera, LightsPanel::tr("Turns with the camera") },
    { LightKind::Directional, LightsPanel::tr("Direction in the patient") },
    { LightKind::Positional, LightsPanel::tr("Point in the patient") },
  };
}

QString NameOfLight(LightKind kind)
{
  const std::vector<LightText> texts = LightTexts();
  return std::find_if(
    texts.begin(), texts.end(), [kind](const LightText& text) { return text.kind == kind; })
    ->name;
}

QColor ColorOfLight(const SceneLight& light)
{
  return QColor::fromRgbF(light.rgb[0], light.rgb[1], light.rgb[2]);
}

QIcon PatchOf(const QColor& color)
{
  QPixmap patch(16, 16);
  patch.fill(color);
  return patch;
}

bool HasDirection(LightKind kind)
{
  return kind == LightKind::Camera || kind == LightKind::Directional;
}

}

LightsPanel::LightsPanel(SceneModel* model, QWidget* parent)
  : QWidget(parent)
  , model(model)
  , remove(new QPushButton(tr("Remove")))
  , list(new QListWidget)
  , form(new QFormLayout)
{
  this->setObjectName("lightsPanel");
  this->list->setObjectName("lightsList");
  this->list->setAccessibleName(tr("Lights"));
  this->list->setMaximumHeight(110);
  this->remove->setObjectName("removeLight");
  auto* const column = new QVBoxLayout(this);
  auto* const row = new QHBoxLayout;
  row->addWidget(this->MakeAddButton());
  row->addWidget(this->remove);
  row->addStretch();
  column->addLayout(row);
  column->addWidget(this->list);
  column->addLayout(this->form);
  column->addWidget(new LightEffectsBox(model));
  column->addStretch();
  this->MakeColorAndIntensity();
  this->MakeDirection();
  this->MakePosition();
  this->setEnabled(false);
  connect(this->remove, &QPushButton::clicked, this, &LightsPanel::Remove);
  connect(this->list, &QListWidget::currentRowChanged, this, &LightsPanel::ShowSelected);
  connect(model, &SceneModel::Changed, this, &LightsPanel::Show);
}

QToolButton* LightsPanel::MakeAddButton()
{
  this->add = new QToolButton;
  this->add->setObjectName("addLight");
  this->add->setText(tr("Add a light"));
  this->add->setPopupMode(QToolButton::InstantPopup);
  auto* const menu = new QMenu(this->add);
  for (const LightText& text : LightTexts())
  {
    menu->addAction(text.name, this, [this, kind = text.kind] { this->Add(kind); });
  }
  this->add->setMenu(menu);
  return this->add;
}

void LightsPanel::MakeColorAndIntensity()
{
  this->color = new QPushButton(tr("Choose…"));
  this->color->setObjectName("lightColor");
  connect(this->color, &QPushButton::clicked, this, &LightsPanel::ChooseColor);
  this->form->addRow(tr("Colour"), this->color);
  this->intensity = new NumberSlider(0.05, 5.0, NumberSlider::Scale::Logarithmic);
  this->intensity->setObjectName("lightIntensity");
  connect(this->intensity, &NumberSlider::Edited, this,
    [this](double number, int gesture)
    {
      this->EditSelected(
        tr("intensity of a light"), [=](SceneLight& light) { light.intensity = number; }, gesture);
    });
  this->form->addRow(tr("Intensity"), this->intensity);
  this->softness = new NumberSlider(0.0, 60.0, NumberSlider::Scale::Linear);
  this->softness->setObjectName("lightSoftness");
  this->softness->SetSuffix(tr("°"));
  this->softness->setToolTip(
    tr("How soft its shadows are: half the angle of the cone that the light comes from."));
  connect(this->softness, &NumberSlider::Edited, this,
    [this](double number, int gesture)
    {
      this->EditSelected(
        tr("softness of a light"), [=](SceneLight& light) { light.softnessDegrees = number; },
        gesture);
    });
  this->form->addRow(tr("Softness"), this->softness);
}

void LightsPanel::MakeDirection()
{
  const auto add = [this](const char* name, double largest, double LightAngles::*angle)
  {
    auto* const slider = new NumberSlider(-largest, largest, NumberSlider::Scale::Linear);
    slider->setObjectName(name);
    slider->SetSuffix(tr("°"));
    connect(slider, &NumberSlider::Edited, this,
      [=](double degrees, int gesture)
      {
        this->EditSelected(
          tr("direction of a light"),
          [=](SceneLight& light)
          {
            LightAngles angles = AnglesOf(light.direction, light.kind);
            angles.*angle = degrees;
            light.direction = DirectionOf(angles, light.kind);
          },
          gesture);
      });
    return slider;
  };
  this->azimuth = add("lightAzimuth", 180.0, &LightAngles::azimuthDegrees);
  // Directly above, the azimuth would be lost.
  this->elevation = add("lightElevation", 89.0, &LightAngles::elevationDegrees);
  this->form->addRow(tr("To the right"), this->azimuth);
  this->form->addRow(tr("Upwards"), this->elevation);
}

void LightsPanel::MakePosition()
{
  constexpr double Farthest = 1e4;
  this->position = new QWidget;
  this->position->setObjectName("lightPosition");
  auto* const column = new QVBoxLayout(this->position);
  column->setContentsMargins(0, 0, 0, 0);
  auto* const row = new QHBoxLayout;
  const QString names[] = { tr("Place to the patient's left [mm]"), tr("Place to the back [mm]"),
    tr("Place to the head [mm]") };
  for (int axis = 0; axis < 3; ++axis)
  {
    auto* const box = new QDoubleSpinBox;
    box->setAccessibleName(names[axis]);
    box->setRange(-Farthest, Farthest);
    box->setDecimals(1);
    box->setKeyboardTracking(false);
    box->setToolTip(tr("Left, back, head of the patient [mm]"));
    connect(box, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
      [this, axis](double millimetres)
      {
        this->EditSelected(
          tr("place of a light"), [=](SceneLight& light) { light.positionMm[axis] = millimetres; });
      });
    row->addWidget(box, 1);
    this->coordinates[axis] = box;
  }
  column->addLayout(row);
  auto* const toCrosshair = new QPushButton(tr("Move to the crosshair of the slices"));
  toCrosshair->setObjectName("lightToCrosshair");
  connect(toCrosshair, &QPushButton::clicked, this, &LightsPanel::MoveToCrosshair);
  column->addWidget(toCrosshair);
  this->form->addRow(tr("Place [mm]"), this->position);
}

std::vector<SceneLight> LightsPanel::Shown() const
{
  const std::vector<SceneLight>& lights = this->model->CurrentScene().lights;
  return lights.empty() ? std::vector<SceneLight>{ SceneLight() } : lights;
}

void LightsPanel::Replace(const std::vector<SceneLight>& lights, const QString& name, int gesture)
{
  this->model->Edit(
    ScenePart::Lights, name, [&](Scene& scene) { scene.lights = lights; }, gesture);
}

void LightsPanel::EditSelected(
  const QString& name, const std::function<void(SceneLight&)>& change, int gesture)
{
  std::vector<SceneLight> lights = this->Shown();
  change(lights[std::size_t(this->list->currentRow())]);
  this->Replace(lights, name, gesture);
}

void LightsPanel::Add(LightKind kind)
{
  constexpr LightAngles FromTheUpperRight = { 45.0, 45.0 };
  SceneLight light;
  light.kind = kind;
  light.direction = DirectionOf(FromTheUpperRight, kind);
  light.positionMm = MiddleOf(this->model->CurrentStudy()->volume.image);
  std::vector<SceneLight> lights = this->Shown();
  lights.push_back(light);
  this->Replace(lights, tr("add a light"), SceneModel::NoGesture);
  this->list->setCurrentRow(int(lights.size()) - 1);
}

void LightsPanel::Remove()
{
  std::vector<SceneLight> lights = this->Shown();
  lights.erase(lights.begin() + this->list->currentRow());
  this->Replace(lights, tr("remove a light"), SceneModel::NoGesture);
}

void LightsPanel::ChooseColor()
{
  const std::vector<SceneLight> before = this->Shown();
  const int gesture = NewGesture();
  const auto edit = [this, gesture](const QColor& chosen)
  {
    this->EditSelected(
      tr("colour of a light"),
      [&](SceneLight& light) {
        light.rgb = { chosen.redF(), chosen.greenF(), chosen.blueF() };
      },
      gesture);
  };
  const QColorDialog* const dialog =
    OpenLiveColorDialog(ColorOfLight(before[std::size_t(this->list->currentRow())]), edit, this);
  connect(dialog, &QDialog::rejected, this,
    [this, before, gesture] { this->Replace(before, tr("colour of a light"), gesture); });
}

void LightsPanel::MoveToCrosshair()
{
  const std::array<double, 3> point = this->model->CurrentScene().slices.crosshairMm.value_or(
    MiddleOf(this->model->CurrentStudy()->volume.image));
  this->EditSelected(tr("place of a light"), [&](SceneLight& light) { light.positionMm = point; });
}

void LightsPanel::Show(ScenePart part)
{
  if (part != ScenePart::Lights && part != ScenePart::Volume)
  {
    return;
  }
  this->setEnabled(true);
  const std::vector<SceneLight> lights = this->Shown();
  const int selected = std::clamp(this->list->currentRow(), 0, int(lights.size()) - 1);
  const QSignalBlocker quiet(this->list);
  this->list->clear();
  for (const SceneLight& light : lights)
  {
    this->list->addItem(new QListWidgetItem(PatchOf(ColorOfLight(light)), NameOfLight(light.kind)));
  }
  this->list->setCurrentRow(selected);
  this->add->setEnabled(lights.size() < MostLights);
  this->remove->setEnabled(lights.size() > 1);
  this->ShowSelected();
}

void LightsPanel::ShowSelected()
{
  const int row = this->list->currentRow();
  if (row < 0)
  {
    return;
  }
  const SceneLight light = this->Shown()[std::size_t(row)];
  this->color->setIcon(PatchOf(ColorOfLight(light)));
  this->intensity->SetNumber(light.intensity);
  this->softness->SetNumber(light.softnessDegrees);
  this->ShowRow(this->softness, light.kind != LightKind::Head);
  this->ShowRow(this->azimuth, HasDirection(light.kind));
  this->ShowRow(this->elevation, HasDirection(light.kind));
  this->ShowRow(this->position, light.kind == LightKind::Positional);
  if (HasDirection(light.kind))
  {
    const LightAngles angles = AnglesOf(light.direction, light.kind);
    this->azimuth->SetNumber(angles.azimuthDegrees);
    this->elevation->SetNumber(angles.elevationDegrees);
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    const QSignalBlocker quiet(this->coordinates[axis]);
    this->coordinates[axis]->setValue(light.positionMm[axis]);
  }
}

void LightsPanel::ShowRow(QWidget* field, bool shown)
{
  field->setVisible(shown);
  this->form->labelForField(field)->setVisible(shown);
}

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
