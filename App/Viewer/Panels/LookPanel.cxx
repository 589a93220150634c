#include "Viewer/Panels/LookPanel.h"

#include "Scene/OutputFile.h"
#include "Scene/Presets.h"
#include "Scene/SceneFile.h"
#include "Scene/SceneNames.h"
#include "Scene/SlicerProperty.h"
#include "Scene/VolumeProperty.h"
#include "Viewer/Model/Gesture.h"
#include "Viewer/Panels/NumberSlider.h"
#include "Viewer/TransferFunctionEditor/TransferFunctionEditor.h"

#include <QComboBox>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolBar>
#include <QVBoxLayout>

#include <exception>
#include <stdexcept>

namespace varimarch
{

namespace
{

bool IsSlicerProperty(const QString& path)
{
  return QFileInfo(path).suffix().compare("vp", Qt::CaseInsensitive) == 0;
}

Look ReadSlicerProperty(const QString& path)
{
  constexpr qint64 MostBytes = 4 << 20;
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly))
  {
    throw std::runtime_error(
      "Cannot read " + path.toStdString() + ": " + file.errorString().toStdString());
  }
  return LookFromSlicerText(file.read(MostBytes).toStdString(), path.toStdString());
}

}

LookPanel::LookPanel(SceneModel* model, QWidget* parent)
  : QWidget(parent)
  , model(model)
{
  this->setObjectName("lookPanel");
  auto* const column = new QVBoxLayout(this);
  this->MakePresets(column);
  this->MakeEditor(column);
  this->MakeBlending(column);
  this->MakeShading(column);
  this->setEnabled(false);
  connect(model, &SceneModel::Changed, this, &LookPanel::Update);
}

void LookPanel::MakePresets(QVBoxLayout* column)
{
  this->presets = new QComboBox;
  this->presets->setObjectName("presets");
  this->presets->setAccessibleName(tr("Preset"));
  for (const std::string& name : PresetNames())
  {
    this->presets->addItem(QString::fromStdString(name));
    this->presets->setItemData(this->presets->count() - 1,
      QString::fromStdString(Preset(name).description), Qt::ToolTipRole);
  }
  connect(this->presets, QOverload<int>::of(&QComboBox::activated), this,
    [this](int index)
    {
      const QString name = this->presets->itemText(index);
      if (IsPresetName(name.toStdString()))
      {
        this->model->SetLook(Preset(name.toStdString()), tr("choose %1").arg(name));
      }
    });
  auto* const load = new QPushButton(tr("Load look…"));
  auto* const save = new QPushButton(tr("Save look…"));
  connect(load, &QPushButton::clicked, this, &LookPanel::ChooseFileToLoad);
  connect(save, &QPushButton::clicked, this, &LookPanel::ChooseFileToSave);
  auto* const row = new QHBoxLayout;
  row->addWidget(this->presets, 1);
  row->addWidget(load);
  row->addWidget(save);
  column->addLayout(row);

  this->problem = new QLabel;
  this->problem->setObjectName("problem");
  this->problem->setWordWrap(true);
  this->problem->setTextInteractionFlags(Qt::TextSelectableByMouse);
  this->problem->hide();
  column->addWidget(this->problem);
}

void LookPanel::MakeEditor(QVBoxLayout* column)
{
  this->editor = new TransferFunctionEditor;
  auto* const tools = new QToolBar;
  tools->setToolButtonStyle(Qt::ToolButtonTextOnly);
  tools->addActions(this->editor->ViewActions());
  column->addWidget(tools);
  column->addWidget(this->editor, 1);
  connect(this->editor, &TransferFunctionEditor::LookEdited, this,
    [this](const Look& look, const QString& name, int gesture)
    { this->model->SetLook(look, name, gesture); });
}

void LookPanel::MakeBlending(QVBoxLayout* column)
{
  auto* const form = new QFormLayout;
  this->blend = new QComboBox;
  this->blend->setObjectName("blend");
  for (const std::string& name : NamesOf(BlendNames()))
  {
    this->blend->addItem(QString::fromStdString(name));
  }
  connect(this->blend, QOverload<int>::of(&QComboBox::activated), this,
    [this](int index)
    {
      this->EditLook(tr("blending"), SceneModel::NoGesture,
        [index](Look& look) { look.blend = BlendNames()[index].second; });
    });
  form->addRow(tr("Blending"), this->blend);

  this->unitDistance = new NumberSlider(0.01, 100.0, NumberSlider::Scale::Logarithmic);
  this->unitDistance->setObjectName("unitDistance");
  this->unitDistance->SetSuffix(tr(" mm"));
  this->unitDistance->setToolTip(tr("The thickness of material that has the curve's opacities"));
  connect(this->unitDistance, &NumberSlider::Edited, this,
    [this](double millimetres, int gesture)
    {
      this->EditLook(tr("opacity distance"), gesture,
        [=](Look& look) { look.opacityUnitDistanceMm = millimetres; });
    });
  form->addRow(tr("Opacity per"), this->unitDistance);
  column->addLayout(form);
}

void LookPanel::MakeShading(QVBoxLayout* column)
{
  this->shading = new QGroupBox(tr("Shading"));
  this->shading->setObjectName("shading");
  this->shading->setCheckable(true);
  connect(this->shading, &QGroupBox::clicked, this,
    [this](bool on)
    {
      this->EditLook(
        tr("shading"), SceneModel::NoGesture, [on](Look& look) { look.shading.enabled = on; });
    });
  this->coefficients = new QFormLayout(this->shading);
  using Scale = NumberSlider::Scale;
  this->AddCoefficient(tr("Ambient"), &Shading::ambient, new NumberSlider(0, 1, Scale::Linear));
  this->AddCoefficient(tr("Diffuse"), &Shading::diffuse, new NumberSlider(0, 1, Scale::Linear));
  this->AddCoefficient(tr("Specular"), &Shading::specular, new NumberSlider(0, 1, Scale::Linear));
  this->AddCoefficient(
    tr("Power"), &Shading::specularPower, new NumberSlider(1, 1000, Scale::Logarithmic));
  column->addWidget(this->shading);
}

void LookPanel::AddCoefficient(
  const QString& name, double Shading::*coefficient, NumberSlider* slider)
{
  slider->setObjectName(name);
  connect(slider, &NumberSlider::Edited, this,
    [=](double number, int gesture)
    {
      this->EditLook(
        name.toLower(), gesture, [=](Look& look) { look.shading.*coefficient = number; });
    });
  this->coefficients->addRow(name, slider);
  this->sliders.emplace_back(slider, coefficient);
}

void LookPanel::EditLook(const QString& name, int gesture, const std::function<void(Look&)>& change)
{
  Look changed = this->model->CurrentScene().look;
  change(changed);
  this->model->SetLook(changed, name, gesture);
}

void LookPanel::Update(ScenePart part)
{
  if (part != ScenePart::Look && part != ScenePart::Volume)
  {
    return;
  }
  const Look& look = this->model->CurrentScene().look;
  this->editor->SetLook(look);
  if (part == ScenePart::Volume)
  {
    const auto study = this->model->CurrentStudy();
    this->setEnabled(true);
    this->editor->SetUnit(study->volume.modality == "CT" ? tr("HU") : tr("value"));
    this->editor->SetStatistics({ study, &study->statistics });
  }
  this->ShowPreset();
  this->blend->setCurrentText(QString::fromStdString(NameOf(BlendNames(), look.blend)));
  this->unitDistance->SetNumber(look.opacityUnitDistanceMm);
  this->shading->setChecked(look.shading.enabled);
  for (const auto& [slider, coefficient] : this->sliders)
  {
    slider->SetNumber(look.shading.*coefficient);
  }
}

// The list shows a preset only while the look is still what the preset says; else a row of its own,
// the last, says what it was.
void LookPanel::ShowPreset()
{
  const Look& look = this->model->CurrentScene().look;
  const bool isPreset = IsPresetName(look.name) &&
    LookText(InUnitsOfData(Preset(look.name), this->model->CurrentStudy()->statistics)) ==
      LookText(look);
  const int presetCount = int(PresetNames().size());
  this->presets->removeItem(presetCount);
  const QString name = QString::fromStdString(look.name);
  if (isPreset)
  {
    this->presets->setCurrentText(name);
  }
  else
  {
    this->presets->addItem(IsPresetName(look.name) ? tr("%1, edited").arg(name)
        : name.isEmpty()                           ? tr("own look")
                                                   : name);
    this->presets->setCurrentIndex(presetCount);
  }
}

void LookPanel::ChooseFileToLoad()
{
  const QString path = QFileDialog::getOpenFileName(
    this, tr("Load a look"), {}, tr("Looks (*.json);;3D Slicer volume properties (*.vp)"));
  if (!path.isEmpty())
  {
    this->Load(path);
  }
}

void LookPanel::ChooseFileToSave()
{
  const QString path = QFileDialog::getSaveFileName(
    this, tr("Save the look"), {}, tr("Looks (*.json);;3D Slicer volume properties (*.vp)"));
  if (!path.isEmpty())
  {
    this->Save(QFileInfo(path).suffix().isEmpty() ? path + ".json" : path);
  }
}

void LookPanel::Load(const QString& path)
{
  this->Attempt(
    [&]
    {
      const Look look =
        IsSlicerProperty(path) ? ReadSlicerProperty(path) : ReadLook(path.toStdString());
      this->model->SetLook(look, tr("load %1").arg(QFileInfo(path).fileName()));
    });
}

void LookPanel::Save(const QString& path)
{
  this->Attempt(
    [&]
    {
      Look look = this->model->CurrentScene().look;
      look.name = QFileInfo(path).completeBaseName().toStdString();
      WriteFileWhole(
        path.toStdString(), IsSlicerProperty(path) ? SlicerText(look) : LookText(look));
    });
}

void LookPanel::Attempt(const std::function<void()>& action)
{
  this->problem->hide();
  try
  {
    action();
  }
  catch (const std::exception& failure)
  {
    this->problem->setText(QString::fromStdString(failure.what()));
    this->problem->show();
  }
}

}
