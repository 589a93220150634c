#include "Viewer/Panels/LightsPanel.h"

#include "Scene/SceneCuts.h"
#include "Scene/SceneLights.h"
#include "Viewer/LiveColorDialog.h"
#include "Viewer/Panels/LightEffectsBox.h"
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

}
