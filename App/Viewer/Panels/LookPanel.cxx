#include "Viewer/Panels/LookPanel.h"

#include "Scene/Looks/LookFiles.h"
#include "Scene/Looks/Presets.h"
#include "Scene/Looks/VolumeProperty.h"
#include "Viewer/Dialogs.h"
#include "Viewer/Model/GradientCounting.h"
#include "Viewer/Model/OwnPresets.h"
#include "Viewer/Panels/LookBoxes.h"
#include "Viewer/Panels/NumberSlider.h"
#include "Viewer/TransferFunctionEditor/LookEditing.h"
#include "Viewer/TransferFunctionEditor/TransferFunctionEditor.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QIcon>
#include <QImage>
#include <QInputDialog>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <exception>
#include <utility>

namespace varimarch
{

namespace
{

QIcon PictureOf(const ColorMap& map)
{
  constexpr int Width = 96;
  constexpr int Height = 16;
  const TransferFunction function(map.nodes, {}, 1.0);
  QImage image(Width, Height, QImage::Format_RGB32);
  for (int x = 0; x < Width; ++x)
  {
    for (int y = 0; y < Height; ++y)
    {
      image.setPixelColor(x, y, QColorOf(function.Color((x + 0.5) / Width)));
    }
  }
  return QPixmap::fromImage(image);
}

// Filters of a file dialog: "Looks (*.json)", "3D Slicer volume properties (*.vp.json)" ...
QStringList FileFilters(bool toWrite)
{
  QStringList all;
  QStringList lines;
  for (const LookFileFormat& format : LookFileFormats())
  {
    if (format.canBeWritten || !toWrite)
    {
      const QString pattern = "*" + QString::fromStdString(format.extension);
      all += pattern;
      lines += QStringLiteral("%1 (%2)").arg(QString::fromStdString(format.description), pattern);
    }
  }
  if (!toWrite)
  {
    lines.prepend(LookPanel::tr("All looks (%1)").arg(all.join(' ')));
  }
  return lines;
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
  column->addWidget(new ChannelsBox(model));
  column->addWidget(new BlendingForm(model));
  auto* const counting = new GradientCounting(model, this);
  column->addWidget(new GradientOpacityBox(model, counting));
  column->addWidget(new RegionsBox(model, counting));
  column->addWidget(new ShadingBox(model));
  // The entries are longer in some languages, and must not widen the panel.
  for (QComboBox* const box : this->findChildren<QComboBox*>())
  {
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(8);
  }
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
    this->presets->addItem(PresetTitle(name), QString::fromStdString(name));
    this->presets->setItemData(this->presets->count() - 1,
      QString::fromStdString(BuiltInPreset(name).look.description), Qt::ToolTipRole);
  }
  connect(this->presets, QOverload<int>::of(&QComboBox::activated), this,
    [this](int index)
    {
      const std::string name = this->presets->itemData(index).toString().toStdString();
      if (IsPresetName(name))
      {
        this->model->SetPreset(BuiltInPreset(name), tr("choose %1").arg(PresetTitle(name)));
      }
    });
  auto* const load = new QPushButton(tr("Load…"));
  load->setToolTip(tr("Loads a look from a file"));
  auto* const save = new QPushButton(tr("Save…"));
  save->setToolTip(tr("Saves the look in a file"));
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
  tools->addWidget(this->MakeColorMaps());
  column->addWidget(tools);
  column->addWidget(this->editor, 1);
  this->counted = new QLabel;
  this->counted->setObjectName("countedTimes");
  this->counted->hide();
  column->addWidget(this->counted);
  connect(this->editor, &TransferFunctionEditor::LookEdited, this,
    [this](const Look& look, const QString& name, int gesture)
    { this->model->SetLook(look, name, gesture); });
}

QToolButton* LookPanel::MakeColorMaps()
{
  auto* const button = new QToolButton;
  button->setObjectName("colorMaps");
  button->setText(tr("Colours"));
  button->setToolTip(
    tr("Colour maps for any kind of colour vision; the opacity curve stays as it is"));
  button->setPopupMode(QToolButton::InstantPopup);
  auto* const menu = new QMenu(button);
  for (const ColorMap& map : ColorMaps())
  {
    const QString name = QString::fromStdString(map.name);
    menu->addAction(PictureOf(map), name, this,
      [this, &map, name]
      {
        const ImageStatistics& statistics = this->model->EditedStudy()->statistics;
        this->model->SetLook(
          WithColorMap(this->model->EditedLook(), map, statistics.Smallest(), statistics.Largest()),
          tr("colour map %1").arg(name));
      });
  }
  button->setMenu(menu);
  return button;
}

void LookPanel::Update(ScenePart part)
{
  if (part == ScenePart::Voxels && !this->counted->isHidden() &&
    this->model->EditedStudy()->allTimes)
  {
    this->ShowHistogram();
  }
  if (part != ScenePart::Look && !IsOtherLookVolume(part))
  {
    return;
  }
  const Look& look = this->model->EditedLook();
  this->editor->SetLook(look);
  if (IsOtherLookVolume(part))
  {
    const auto study = this->model->EditedStudy();
    this->setEnabled(true);
    this->editor->SetUnit(study->volume.modality == "CT" ? tr("HU") : tr("value"));
    this->ShowHistogram();
  }
  this->ShowPreset();
}

// A copy, since the study would keep the voxels of its time in memory.
void LookPanel::ShowHistogram()
{
  const auto study = this->model->EditedStudy();
  this->editor->SetStatistics(
    study->allTimes ? study->allTimes : std::make_shared<const ImageStatistics>(study->statistics));
  const LoadedTimes& times = study->volume.times;
  this->counted->setText(tr("The histogram is of %1 of %2 times").arg(1).arg(times.values.size()));
  this->counted->setVisible(times.AreSeveral() && !study->allTimes);
}

// Shows the preset's name while the look equals the preset. Otherwise an additional last row names
// the edited look.
void LookPanel::ShowPreset()
{
  const Look& look = this->model->EditedLook();
  const bool isPreset = IsBuiltInLook(look, this->model->EditedStudy()->statistics);
  const int presetCount = int(PresetNames().size());
  this->presets->removeItem(presetCount);
  if (isPreset)
  {
    this->presets->setCurrentIndex(this->presets->findData(QString::fromStdString(look.name)));
  }
  else
  {
    const QString title = PresetTitle(look.name);
    this->presets->addItem(IsPresetName(look.name) ? tr("%1, edited").arg(title)
        : title.isEmpty()                          ? tr("custom look")
                                                   : title);
    this->presets->setCurrentIndex(presetCount);
  }
}

void LookPanel::ChooseFileToLoad()
{
  const QString path =
    QFileDialog::getOpenFileName(this, tr("Load a look"), {}, FileFilters(false).join(";;"));
  if (!path.isEmpty())
  {
    this->Load(path);
  }
}

void LookPanel::ChooseFileToSave()
{
  const QString path = ChosenFileToSave(this, tr("Save the look"), FileFilters(true), QString());
  if (!path.isEmpty())
  {
    this->Save(path);
  }
}

void LookPanel::Load(const QString& path)
{
  this->Attempt(
    [&]
    {
      const std::vector<Preset> presets = ReadLookFile(path.toStdString(), this->FileContext());
      if (const std::optional<std::size_t> chosen = this->ChosenLook(presets))
      {
        this->model->SetPreset(presets[*chosen], tr("load %1").arg(QFileInfo(path).fileName()));
      }
    });
}

std::optional<std::size_t> LookPanel::ChosenLook(const std::vector<Preset>& presets)
{
  if (presets.size() == 1)
  {
    return 0;
  }
  QStringList names;
  for (const Preset& preset : presets)
  {
    names.append(QString::fromStdString(preset.look.name));
  }
  bool isChosen = false;
  const QString name = QInputDialog::getItem(this, tr("Load a look"),
    tr("The file holds %n looks:", nullptr, names.size()), names, 0, false, &isChosen);
  return isChosen ? std::optional<std::size_t>(names.indexOf(name)) : std::nullopt;
}

void LookPanel::Save(const QString& path)
{
  this->Attempt(
    [&] {
      WriteLookFile(PresetOf(this->model->EditedScene()), path.toStdString(), this->FileContext());
    });
}

LookContext LookPanel::FileContext() const
{
  LookContext context = ContextOf(this->model->EditedStudy()->volume.image);
  context.opacities = this->model->EditedLook().opacities;
  return context;
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

namespace
{

// Lengths for a patient. Other volumes may be much smaller or larger.
constexpr double ShortestUnitMm = 0.01;
constexpr double LongestUnitMm = 100.0;

// Name of a blend mode and its purpose.
struct BlendText
{
  Blend blend;
  QString name;
  QString purpose;
};

std::vector<BlendText> BlendTexts()
{
  return {
    { Blend::Composite, BlendingForm::tr("Composite"),
      BlendingForm::tr("Translucent material with the opacities of the curve") },
    { Blend::MaximumIntensity, BlendingForm::tr("Maximum"),
      BlendingForm::tr("The largest value along each ray: vessels, implants (MIP)") },
    { Blend::MinimumIntensity, BlendingForm::tr("Minimum"),
      BlendingForm::tr("The smallest value along each ray: airways (MinIP)") },
    { Blend::AverageIntensity, BlendingForm::tr("Average"),
      BlendingForm::tr("The mean along each ray, as in a thick slice") },
    { Blend::Additive, BlendingForm::tr("Additive"),
      BlendingForm::tr("The sum along each ray, as in an X-ray image") },
    { Blend::Isosurface, BlendingForm::tr("Isosurfaces"),
      BlendingForm::tr("Surfaces of equal value, each with its colour and opacity") },
  };
}

}

BlendingForm::BlendingForm(SceneModel* model, QWidget* parent)
  : QWidget(parent)
  , model(model)
  , form(new QFormLayout(this))
{
  this->form->setContentsMargins(0, 0, 0, 0);
  this->MakeBlend();
  this->MakeUnitDistance();
  this->MakeAveragedRange();
  connect(model, &SceneModel::Changed, this, &BlendingForm::Update);
}

void BlendingForm::MakeBlend()
{
  this->blend = new QComboBox;
  this->blend->setObjectName("blend");
  for (const BlendText& text : BlendTexts())
  {
    this->blend->addItem(text.name, int(text.blend));
    this->blend->setItemData(this->blend->count() - 1, text.purpose, Qt::ToolTipRole);
  }
  connect(this->blend, QOverload<int>::of(&QComboBox::activated), this,
    [this](int index) { this->ChooseBlend(Blend(this->blend->itemData(index).toInt())); });
  this->form->addRow(tr("Blend mode"), this->blend);
}

void BlendingForm::MakeUnitDistance()
{
  this->unitDistance =
    new NumberSlider(ShortestUnitMm, LongestUnitMm, NumberSlider::Scale::Logarithmic);
  this->unitDistance->setObjectName("unitDistance");
  this->unitDistance->SetSuffix(tr(" mm"));
  connect(this->unitDistance, &NumberSlider::Edited, this,
    [this](double millimetres, int gesture)
    {
      Look look = this->model->EditedLook();
      look.opacityUnitDistanceMm = millimetres;
      this->model->SetLook(look, tr("opacity distance"), gesture);
    });
  this->form->addRow(tr("Opacity per"), this->unitDistance);
}

void BlendingForm::MakeAveragedRange()
{
  this->averagedRange = new QWidget;
  this->averagedRange->setObjectName("averagedRange");
  this->averagedRange->setToolTip(tr("Values outside this range do not count in the mean"));
  auto* const row = new QHBoxLayout(this->averagedRange);
  row->setContentsMargins(0, 0, 0, 0);
  const auto add = [&](const char* name, const QString& meaning)
  {
    auto* const box = new QDoubleSpinBox;
    box->setAccessibleName(meaning);
    box->setObjectName(name);
    box->setKeyboardTracking(false);
    row->addWidget(box, 1);
    connect(box, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
      &BlendingForm::ChooseAveragedRange);
    return box;
  };
  this->averagedFirst = add("averagedFirst", tr("Smallest value of the mean"));
  row->addWidget(new QLabel(tr("to")));
  this->averagedLast = add("averagedLast", tr("Largest value of the mean"));
  this->form->addRow(tr("Values from"), this->averagedRange);
}

void BlendingForm::ChooseBlend(Blend chosen)
{
  Look look = this->model->EditedLook();
  look = chosen == Blend::Isosurface ? WithSurface(look) : look;
  look.blend = chosen;
  this->model->SetLook(look, tr("blend mode"));
}

void BlendingForm::ChooseAveragedRange()
{
  const auto study = this->model->EditedStudy();
  const double first = std::min(this->averagedFirst->value(), this->averagedLast->value());
  const double last = std::max(this->averagedFirst->value(), this->averagedLast->value());
  const bool all = first <= study->statistics.Smallest() && last >= study->statistics.Largest();
  Look look = this->model->EditedLook();
  look.averagedRange = all ? std::nullopt : std::optional(std::array<double, 2>{ first, last });
  this->model->SetLook(look, tr("range of averaged values"));
}

void BlendingForm::ShowRow(QWidget* field, bool shown)
{
  field->setVisible(shown);
  this->form->labelForField(field)->setVisible(shown);
}

void BlendingForm::ShowUnitDistance(double millimetres, double lengthFactor)
{
  this->unitDistance->SetRange(std::min(lengthFactor * ShortestUnitMm, millimetres),
    std::max(lengthFactor * LongestUnitMm, millimetres));
  this->unitDistance->SetNumber(millimetres);
  const QString meaning = tr("Thickness of material that has the opacities of the curve");
  this->unitDistance->setToolTip(lengthFactor == 1.0 ? meaning
                                                     : meaning +
        tr(". Presets set it by the size of the volume, which is not known to show a "
           "patient"));
}

void BlendingForm::Update(ScenePart part)
{
  if (part != ScenePart::Look && !IsOtherLookVolume(part))
  {
    return;
  }
  const Look& look = this->model->EditedLook();
  const ImageStatistics& statistics = this->model->EditedStudy()->statistics;
  this->blend->setCurrentIndex(this->blend->findData(int(look.blend)));
  this->ShowUnitDistance(look.opacityUnitDistanceMm, statistics.LengthFactor());
  const std::array<double, 2> range = look.averagedRange.value_or(
    std::array<double, 2>{ statistics.Smallest(), statistics.Largest() });
  for (const auto& [box, value] :
    { std::pair(this->averagedFirst, range[0]), std::pair(this->averagedLast, range[1]) })
  {
    const QSignalBlocker quiet(box);
    const double width = statistics.Largest() - statistics.Smallest();
    box->setDecimals(width < 100.0 ? 3 : 0);
    box->setSingleStep(width < 100.0 ? 0.01 * width : 10.0);
    box->setRange(statistics.Smallest(), statistics.Largest());
    box->setValue(value);
  }
  this->ShowRow(
    this->unitDistance, look.blend == Blend::Composite || look.blend == Blend::Additive);
  this->ShowRow(this->averagedRange, look.blend == Blend::AverageIntensity);
}

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
